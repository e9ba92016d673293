#ifndef TICKER_TASKS_SCREENSHOT_JUDGESCREENSHOT_H
#define TICKER_TASKS_SCREENSHOT_JUDGESCREENSHOT_H

#include <grader/result/SubmissionResult.h>
#include <grader/tasks/screenshot/Scene.h>

#include <cstdint>
#include <vector>

namespace ticker::tasks {

/// Judges a decoded screenshot.png: is it a whole picture of a wanted scene, and did this
/// submission's code make it?
///
/// The code is asked for a few windows of the scene at the picture's own pitch, and for the same
/// ones again only where the picture differs. An honest picture, at any size from 320 x 240 pixels
/// with a shape of 4 : 3, also one that took more rays than the handout says, gets a finding above
/// a note with a chance below 3e-7 (option 2), or never (option 1).
///
/// @param scenes  Those that are wanted and others that it might show by mistake; where there are
///                none, the size alone is judged.
/// @param seed    Windows and the code's renders are drawn from it.
[[nodiscard]] TaskJudgement judgeScreenshot(const metrics::ByteView& picture,
                                            const std::vector<screenshot::Scene>& scenes,
                                            std::uint64_t seed);

}  // namespace ticker::tasks

#endif
