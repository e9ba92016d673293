#ifndef TICKER_CALIBRATE_DECISIONTABLES_H
#define TICKER_CALIBRATE_DECISIONTABLES_H

#include <grader/lab/calibrate/Campaign.h>
#include <grader/lab/calibrate/Subject.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ticker::calibrate {

/// Resolution of CPU times, milliseconds.
inline constexpr int kCpuStep = 5;

/// Result of one block of decisions.
struct BlockRecord {
    std::string subject;
    std::uint64_t seed = 0;  ///< of the first decision; the others follow
    bool whole = true;       ///< both tasks were judged; otherwise only the subject's own
    std::size_t decisions = 0;
    std::size_t wrongState = 0;  ///< passed instead of failed, or failed instead of passed
    std::size_t wrongName = 0;   ///< right state, but another first finding
    std::size_t reviews = 0;     ///< the submission needs review
    std::map<std::string, std::size_t> seen;  ///< findings in place of the expected one
    std::map<int, std::size_t> cpu;  ///< decisions by CPU time, probe and judgement, milliseconds

    [[nodiscard]] std::string json() const;
    /// @throws raytracer::Error if the text is not such a record.
    [[nodiscard]] static BlockRecord parse(const std::string& text);
};

/// Counts, bounds of 95 % confidence and CPU times, as Markdown.
[[nodiscard]] Summary tablesOf(const std::vector<Subject>& subjects,
                               const std::vector<std::string>& records);

}  // namespace ticker::calibrate

#endif
