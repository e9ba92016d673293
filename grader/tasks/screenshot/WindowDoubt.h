#ifndef TICKER_TASKS_SCREENSHOT_WINDOWDOUBT_H
#define TICKER_TASKS_SCREENSHOT_WINDOWDOUBT_H

#include <grader/tasks/screenshot/ShownScene.h>
#include <grader/tasks/screenshot/Verification.h>

#include <cstdint>
#include <optional>

namespace ticker::tasks::screenshot {

/// Whether the code renders a region of a frame as it renders that place of a whole frame. Only
/// then may its windows count against a picture, which is always a whole frame.
///
/// A small frame is rendered whole, and again in four regions that cover it. With one ray for each
/// pixel both are equal to the last bit, unless the code has random numbers of its own: then they
/// are compared with the handout's rays, within noise. Code whose whole frames differ as much does
/// not repeat itself: `whyNotRepeated` is about that.
///
/// @param scene  Must have an examinee.
/// @return  The verification of a picture whose windows do not count; empty if they may count.
[[nodiscard]] std::optional<Verification> doubtOfWindows(const Scene& scene, std::uint64_t seed);

}  // namespace ticker::tasks::screenshot

#endif
