#ifndef TICKER_CALIBRATE_DECISIONTABLES_H
#define TICKER_CALIBRATE_DECISIONTABLES_H

#include <grader/lab/calibrate/Campaign.h>
#include <grader/lab/calibrate/Subject.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ticker::calibrate {

/// CPU times are counted in steps of so many milliseconds.
inline constexpr int kCpuStep = 5;

/// What became of one block of decisions.
struct BlockRecord {
    std::string subject;
    std::uint64_t seed = 0;  ///< of the first decision; the others follow
    bool whole = true;       ///< both tasks were judged, else the subject's own alone
    std::size_t decisions = 0;
    std::size_t wrongState = 0;               ///< passed what must fail, or failed what must pass
    std::size_t wrongName = 0;                ///< the state is right, the first finding another one
    std::size_t reviews = 0;                  ///< a person was asked to look
    std::map<std::string, std::size_t> seen;  ///< findings that came in place of the expected
    std::map<int, std::size_t> cpu;  ///< decisions by CPU time, probe and judgement, milliseconds

    [[nodiscard]] std::string json() const;
    /// @throws raytracer::Error where the text is no such record.
    [[nodiscard]] static BlockRecord parse(const std::string& text);
};

/// Counts, bounds of 95 % confidence and CPU times, as Markdown.
[[nodiscard]] Summary tablesOf(const std::vector<Subject>& subjects,
                               const std::vector<std::string>& records);

}  // namespace ticker::calibrate

#endif
