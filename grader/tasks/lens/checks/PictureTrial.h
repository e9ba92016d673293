#ifndef TICKER_TASKS_LENS_CHECKS_PICTURETRIAL_H
#define TICKER_TASKS_LENS_CHECKS_PICTURETRIAL_H

#include <grader/oracle/Reading.h>
#include <grader/tasks/lens/answers/Pictures.h>
#include <grader/tasks/lens/checks/PictureCheck.h>

#include <cstdint>

namespace ticker::tasks {

/// A reading with the picture that it gives.
struct Candidate {
    oracle::Reading reading;
    ExpectedPicture expected;
    double misfit = 0.0;  ///< mean of z^2 over the pixels that were seen
};
[[nodiscard]] Candidate candidateOf(const probe::RenderQuestion& asked, const SeenPictures& seen,
                                    const oracle::Reading& reading, std::uint64_t seed);

/// Whether another reading is tried first: pixels differ by two standard deviations in the root
/// mean square, those of right code by one at most.
[[nodiscard]] constexpr bool isUnlikely(double misfit) {
    return misfit > 4.0;
}

/// The misfit from a rough picture, an eighth of the time: smaller than the real one, and the more
/// so the larger that is.
[[nodiscard]] double roughMisfit(const probe::RenderQuestion& asked, const SeenPictures& seen,
                                 const oracle::Reading& reading, std::uint64_t seed);

struct Trial {
    PictureVerdict verdict;
    double total = 0.0;  ///< sum of z^2 over all tests: how badly the reading fits

    [[nodiscard]] bool fits() const { return !verdict.finding && !verdict.ambiguous; }
};
/// Compares pictures with those of one reading.
[[nodiscard]] Trial tryReading(const probe::RenderQuestion& asked, const SeenPictures& seen,
                               const Candidate& candidate, std::uint64_t seed);

}  // namespace ticker::tasks

#endif
