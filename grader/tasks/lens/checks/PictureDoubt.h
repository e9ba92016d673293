#ifndef TICKER_TASKS_LENS_CHECKS_PICTUREDOUBT_H
#define TICKER_TASKS_LENS_CHECKS_PICTUREDOUBT_H

#include <grader/exercise/Task.h>

#include <optional>
#include <vector>

namespace ticker::tasks {

/// Right pictures have a misfit of 0.04 (stratified points) to 1.05, hard shadows 1.5, no blur 3.2:
/// see the campaign *pictures* in docs/calibration.md.
inline constexpr double kMostMisfit = 1.1;

/// The questions' renders are small, so that code can recognise them, answer rightly and render
/// something else in pictures. If both tasks of option 2 have passed, the picture of the handout's
/// scene must therefore agree with the answers; otherwise the submission goes to review.
/// @param tasks           T2.1 and T2.2; a doubt becomes a warning of T2.2.
/// @param misfits         Misfit of the picture for each aperture that was tried; empty if no
///                        picture came.
/// @param apertureFactor  Aperture factor that the answers show; empty if they show none.
void doubtPicture(std::vector<TaskReport>& tasks, const std::vector<Misfit>& misfits,
                  const std::optional<double>& apertureFactor);

}  // namespace ticker::tasks

#endif
