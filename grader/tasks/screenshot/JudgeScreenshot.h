#ifndef TICKER_TASKS_SCREENSHOT_JUDGESCREENSHOT_H
#define TICKER_TASKS_SCREENSHOT_JUDGESCREENSHOT_H

#include <grader/result/SubmissionResult.h>
#include <grader/tasks/screenshot/ShownScene.h>

#include <cstdint>
#include <vector>

namespace ticker::tasks {

/// Judges a decoded screenshot.png: whether it is a whole picture of a wanted scene, and whether
/// this submission's code rendered it.
///
/// The code is asked for a few windows of the scene at the picture's own pixel size, and a second
/// time only if the picture differs. An honest picture gets a finding above a note with a chance
/// below 3e-7 (option 2), or never (option 1). This holds for any size from 320 x 240 pixels in the
/// shape 4 : 3, for pictures with more rays than the handout asks for, and for code that renders a
/// region otherwise than a whole frame.
///
/// @param scenes  The wanted scenes, and others that the picture may show by mistake. Without
///                scenes only the size is judged.
/// @param seed    Source of the windows and of the code's renders.
[[nodiscard]] TaskJudgement judgeScreenshot(const metrics::ByteView& picture,
                                            const std::vector<screenshot::Scene>& scenes,
                                            std::uint64_t seed);

}  // namespace ticker::tasks

#endif
