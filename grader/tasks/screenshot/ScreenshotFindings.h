#ifndef TICKER_TASKS_SCREENSHOT_SCREENSHOTFINDINGS_H
#define TICKER_TASKS_SCREENSHOT_SCREENSHOTFINDINGS_H

#include <grader/result/FindingText.h>

#include <array>

namespace ticker::tasks {

// The findings of the screenshot. A new finding is one row here and one entry in the table below.

inline constexpr FindingText kScreenshotMissing{.id = "screenshot.missing",
                                                .words = "handed in no screenshot",
                                                .meaning = "no picture was handed in"};

inline constexpr FindingText kScreenshotUnreadable{
    .id = "screenshot.unreadable",
    .words = "handed in a screenshot that is no PNG",
    .meaning = "no PNG, cut short, damaged, animated, or giant: the message says which"};

inline constexpr FindingText kScreenshotWrongSize{
    .id = "screenshot.wrong-size",
    .words = "handed in a screenshot of another size",
    .meaning = "another shape than 4 : 3, or less than 320 x 240 pixels"};

inline constexpr FindingText kScreenshotNotThisScene{
    .id = "screenshot.not-this-scene",
    .words = "handed in a screenshot of something else",
    .meaning = "another scene, a photograph, anything else"};

inline constexpr FindingText kScreenshotEdited{
    .id = "screenshot.edited",
    .words = "handed in a screenshot that was altered",
    .meaning = "mirrored, turned, moved, cropped, in a window, painted over, or in other colours"};

inline constexpr FindingText kScreenshotNotFromThisCode{
    .id = "screenshot.not-from-this-code",
    .words = "handed in a screenshot that this code did not make",
    .meaning =
        "the right scene, but not as this code renders it; the evidence names a known mistake that "
        "it shows"};

inline constexpr FindingText kScreenshotIsTheReference{
    .id = "screenshot.is-the-reference",
    .words = "handed in the reference as a screenshot",
    .meaning =
        "warn, option 2: hardly any noise, as the course's reference picture; a person should "
        "look"};

inline constexpr FindingText kScreenshotColours{
    .id = "screenshot.colours",
    .words = "handed in a screenshot of slightly other colours",
    .meaning = "note: the colours differ by 8 of 255 or less; by more, the picture is edited"};

inline constexpr FindingText kScreenshotResaved{
    .id = "screenshot.resaved",
    .words = "handed in a screenshot that was packed with losses",
    .meaning = "note: small errors everywhere, as JPEG leaves them"};

inline constexpr FindingText kScreenshotUnverified{
    .id = "screenshot.unverified",
    .words = "handed in a screenshot that could not be compared",
    .meaning =
        "note: the code renders whole frames only, or parts otherwise than the whole frame, did "
        "not finish when it was asked for parts, or does not draw the same picture again under "
        "the same seed (threads that meet, points drawn anew or shared by all pixels); the "
        "message says which. warn, a person should look: it shows what this code renders, but "
        "scaled, saved as JPEG, cut by a few pixels or (option 1) softer, as with a solved "
        "Renderer.cpp that was not handed in"};

/// In the order in which they are reported.
inline constexpr std::array kScreenshotFindings{
    &kScreenshotMissing,        &kScreenshotUnreadable, &kScreenshotWrongSize,
    &kScreenshotNotThisScene,   &kScreenshotEdited,     &kScreenshotNotFromThisCode,
    &kScreenshotIsTheReference, &kScreenshotColours,    &kScreenshotResaved,
    &kScreenshotUnverified};

}  // namespace ticker::tasks

#endif
