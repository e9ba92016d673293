#ifndef TICKER_TASKS_SCREENSHOT_REPETITION_H
#define TICKER_TASKS_SCREENSHOT_REPETITION_H

#include <grader/tasks/screenshot/Scene.h>

#include <cstdint>
#include <string>

namespace ticker::tasks::screenshot {

/// Why nothing can be said against a picture of such a size that differs from what the scene's code
/// renders: the code does not repeat itself. The same seed has to give the same pixels to the last
/// bit, in another process, with two threads in place of one, and in another order of the picture's
/// parts; another seed the same picture but for noise. So neither a data race nor points that are
/// drawn anew in each process, or once for all pixels, are held against a picture.
/// @return  Words that go on after a colon; empty where the code repeats itself.
[[nodiscard]] std::string whyNotRepeated(const Scene& scene, int width, int height,
                                         std::uint64_t seed);

}  // namespace ticker::tasks::screenshot

#endif
