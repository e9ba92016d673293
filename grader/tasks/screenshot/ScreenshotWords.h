#ifndef TICKER_TASKS_SCREENSHOT_SCREENSHOTWORDS_H
#define TICKER_TASKS_SCREENSHOT_SCREENSHOTWORDS_H

#include <grader/result/Finding.h>
#include <grader/tasks/screenshot/Agreement.h>
#include <grader/tasks/screenshot/Edits.h>
#include <grader/tasks/screenshot/SeenMistake.h>
#include <grader/tasks/screenshot/Whole.h>

#include <optional>
#include <string>

namespace ticker::tasks::screenshot {

// Words for the student. Ids and their order are in docs/findings.md.

/// @param cut  How the picture and the scene overlap, if known.
[[nodiscard]] Finding wrongSize(const ByteView& picture, const std::optional<Cut>& cut);
/// @param shown  Another known scene that the picture shows; empty if it shows none.
[[nodiscard]] Finding notThisScene(const std::string& wanted, const std::string& shown);

[[nodiscard]] Finding moved(Shift shift);
[[nodiscard]] Finding mirroredPicture(metrics::Mirror mirror);
[[nodiscard]] Finding recoloured(const Recolouring& change);
[[nodiscard]] Finding cutPicture(const ByteView& picture, const Cut& cut);
/// One place differs from the code's render; the rest agrees.
[[nodiscard]] Finding paintedOver(const TileDifference& difference);

[[nodiscard]] Finding notFromThisCode(const ByteView& picture, const Scene& scene,
                                      const Agreement& agreement,
                                      const std::optional<SeenMistake>& mistake);
/// Like notFromThisCode for code that rendered no windows: needs review.
[[nodiscard]] Finding perhapsNotFromThisCode(const ByteView& picture, const Scene& scene,
                                             const TileDifference& difference);
/// The picture shows what this code renders, but with other pixels: needs review.
[[nodiscard]] Finding likeThisCode(const Scene& scene);
/// Option 1's scene with a relief like this code's, but softer: needs review.
[[nodiscard]] Finding perhapsThroughTheLens();
/// @param ratio  The picture's noise divided by the code's.
[[nodiscard]] Finding isTheReference(double ratio);

/// Notes: the picture passes.
[[nodiscard]] Finding slightlyOtherColours(const Recolouring& change);
[[nodiscard]] Finding savedAgain(const Agreement& agreement);
[[nodiscard]] Finding unverified(const std::string& why);

}  // namespace ticker::tasks::screenshot

#endif
