#ifndef TICKER_ORACLE_REFERENCERENDER_H
#define TICKER_ORACLE_REFERENCERENDER_H

#include <grader/oracle/references/References.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace ticker::oracle {

/// The moments that one reference is made from.
[[nodiscard]] Moments momentsOf(const ReferenceScene& scene, double rms, std::uint64_t seed);

/// The linear picture of the means.
[[nodiscard]] raytracer::Image toImage(const Moments& moments);

/// "folder/name" + suffix.
[[nodiscard]] std::filesystem::path fileOf(const std::filesystem::path& folder,
                                           const std::string& name, const char* suffix);

/// Whether the scene's monitor has asked to stop.
[[nodiscard]] bool interrupted(const ReferenceScene& scene);

/// Reports progress over a list of scenes, estimated from the time that their pixels took so far.
class ReferenceClock {
public:
    ReferenceClock(const std::vector<ReferenceScene>& scenes, const ReferenceListener& listener)
        : scenes_(scenes), listener_(listener) {}

    /// Scenes [0, done) are finished.
    void tell(std::size_t done) const;

private:
    [[nodiscard]] double cost(std::size_t first, std::size_t end) const;

    const std::vector<ReferenceScene>& scenes_;
    const ReferenceListener& listener_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace ticker::oracle

#endif
