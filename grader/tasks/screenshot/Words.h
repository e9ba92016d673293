#ifndef TICKER_TASKS_SCREENSHOT_WORDS_H
#define TICKER_TASKS_SCREENSHOT_WORDS_H

#include <grader/result/Finding.h>
#include <grader/tasks/screenshot/Agreement.h>
#include <grader/tasks/screenshot/Edits.h>
#include <grader/tasks/screenshot/SeenMistake.h>
#include <grader/tasks/screenshot/Whole.h>

#include <optional>
#include <string>

namespace ticker::tasks::screenshot {

// What the student reads. Ids and their order: docs/findings.md.

/// @param cut  What the picture was found to be, if anything.
[[nodiscard]] Finding wrongSize(const ByteView& picture, const std::optional<Cut>& cut);
/// @param shown  Another known scene that the picture shows; empty: none.
[[nodiscard]] Finding notThisScene(const std::string& wanted, const std::string& shown);

[[nodiscard]] Finding moved(Shift shift);
[[nodiscard]] Finding mirroredPicture(metrics::Mirror mirror);
[[nodiscard]] Finding recoloured(const Recolouring& change);
[[nodiscard]] Finding cutPicture(const ByteView& picture, const Cut& cut);
/// The rest of the picture is the code's, one place is not.
[[nodiscard]] Finding paintedOver(const TileDifference& difference);

[[nodiscard]] Finding notFromThisCode(const ByteView& picture, const Scene& scene,
                                      const Agreement& agreement,
                                      const std::optional<SeenMistake>& mistake);
/// As above, where no windows of the code's are known: doubt.
[[nodiscard]] Finding perhapsNotFromThisCode(const ByteView& picture, const Scene& scene,
                                             const TileDifference& difference);
/// The picture shows what this code renders, but with other pixels: doubt.
[[nodiscard]] Finding likeThisCode(const Scene& scene);
/// Option 1's scene with a relief like this code's, but softer: doubt.
[[nodiscard]] Finding perhapsThroughTheLens();
/// @param ratio  Of the picture's noise to that of the code.
[[nodiscard]] Finding isTheReference(double ratio);

/// Notes: the picture passes.
[[nodiscard]] Finding slightlyOtherColours(const Recolouring& change);
[[nodiscard]] Finding savedAgain(const Agreement& agreement);
[[nodiscard]] Finding unverified(const std::string& why);

}  // namespace ticker::tasks::screenshot

#endif
