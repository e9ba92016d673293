#ifndef TICKER_TASKS_LENS_CHECKS_PICTURETRIAL_H
#define TICKER_TASKS_LENS_CHECKS_PICTURETRIAL_H

#include <grader/oracle/Reading.h>
#include <grader/tasks/lens/answers/Pictures.h>
#include <grader/tasks/lens/checks/Expectations.h>
#include <grader/tasks/lens/checks/PictureCheck.h>

#include <optional>

namespace ticker::tasks {

/// A reading with the picture that it gives.
struct Candidate {
    oracle::Reading reading;
    const ExpectedPicture* expected = nullptr;  ///< of the expectations
    double misfit = 0.0;                        ///< mean of z^2 over the pixels that were seen
};
[[nodiscard]] Candidate candidateOf(Expectations& expectations, const SeenPictures& seen,
                                    const oracle::Reading& reading);

/// Whether other readings are tried before this one. At the limit pixels differ by two standard
/// deviations in the root mean square; those of right code differ by one at most.
[[nodiscard]] constexpr bool isUnlikely(double misfit) {
    return misfit > 4.0;
}

/// The misfit from a rough picture, which takes an eighth of the time. It is smaller than the real
/// misfit, the more so the larger that is.
[[nodiscard]] double roughMisfit(Expectations& expectations, const SeenPictures& seen,
                                 const oracle::Reading& reading);

/// Whether a rough picture suffices to see that the reading does not fit. Its error is part of
/// every z-score, so that right code is ruled out as rarely as by an exact one.
[[nodiscard]] bool isRuledOut(Expectations& expectations, const SeenPictures& seen,
                              const oracle::Reading& reading);

struct Trial {
    PictureVerdict verdict;
    double total = 0.0;  ///< sum of z^2 over all tests: how badly the reading fits
};
/// Compares pictures with those of one reading.
[[nodiscard]] Trial tryReading(Expectations& expectations, const SeenPictures& seen,
                               const Candidate& candidate);
/// The same, but empty if the reading does not fit. Then it needs fewer templates, often none.
[[nodiscard]] std::optional<Trial> tryToFit(Expectations& expectations, const SeenPictures& seen,
                                            const Candidate& candidate);

}  // namespace ticker::tasks

#endif
