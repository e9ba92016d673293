#ifndef TICKER_CALIBRATE_BLOCKRECORD_H
#define TICKER_CALIBRATE_BLOCKRECORD_H

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace ticker::calibrate {

/// Resolution of CPU times, milliseconds.
inline constexpr int kCpuStep = 5;

/// Result of one block of decisions.
struct BlockRecord {
    std::string subject;
    std::string task;        ///< the one that was judged
    std::uint64_t seed = 0;  ///< of the first decision; the others follow
    std::size_t decisions = 0;
    std::size_t wrongState = 0;  ///< passed instead of failed, or failed instead of passed
    std::size_t wrongName = 0;   ///< right state, but another first finding
    std::size_t reviews = 0;     ///< the submission needs review
    std::map<std::string, std::size_t> seen;  ///< findings in place of the expected one
    std::map<int, std::size_t> cpu;           ///< decisions by CPU time, milliseconds

    [[nodiscard]] std::string json() const;
    /// @throws raytracer::Error if the text is not such a record.
    [[nodiscard]] static BlockRecord parse(const std::string& text);
};

}  // namespace ticker::calibrate

#endif
