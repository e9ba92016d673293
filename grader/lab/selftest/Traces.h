#ifndef TICKER_SELFTEST_TRACES_H
#define TICKER_SELFTEST_TRACES_H

#include <grader/sandbox/UserSlots.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace ticker::selftest {

/// What hostile submissions are tempted with, and the places where they would leave a trace. A
/// folder of our own, gone with this object.
class Traces {
public:
    /// @throws raytracer::Error where the folder or the secret cannot be written.
    Traces();
    ~Traces();
    Traces(const Traces&) = delete;
    Traces& operator=(const Traces&) = delete;

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    /// A file that everybody may read, but that lies in no jail.
    [[nodiscard]] std::filesystem::path secretFile() const { return folder_ / "secret.txt"; }
    /// What must turn up nowhere.
    [[nodiscard]] const std::string& secret() const { return secret_; }

    /// True where the file was written that the corpus tries to write; removes it.
    [[nodiscard]] bool takeEscaped() const;

private:
    std::filesystem::path folder_;
    std::string secret_;
};

/// Processes with a jail's uid although no jail has this uid now; empty where we are not root.
[[nodiscard]] std::vector<std::string> processesLeft(const sandbox::UserRange& users);

/// True where this process has a child.
[[nodiscard]] bool hasChildLeft();

/// What grading could leave behind, as it is now.
struct Footprint {
    std::size_t processes = 0;  ///< of jails that are over, and children of ours
    std::size_t files = 0;      ///< in the folder that is staged for jails
    std::size_t mounts = 0;     ///< that this process sees
    double residentMb = 0.0;    ///< memory of this process
    double sharedMb = 0.0;      ///< the machine's memory files and file systems in memory
    double availableMb = 0.0;   ///< the machine's; others use it, too: for people to read
};
[[nodiscard]] Footprint footprint(const sandbox::UserRange& users);

/// What there is more of afterwards, in a few words each: any process, file or mount, and memory
/// beyond 100 MB.
[[nodiscard]] std::vector<std::string> leftBehind(const Footprint& before, const Footprint& after);

}  // namespace ticker::selftest

#endif
