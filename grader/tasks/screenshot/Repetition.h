#ifndef TICKER_TASKS_SCREENSHOT_REPETITION_H
#define TICKER_TASKS_SCREENSHOT_REPETITION_H

#include <grader/tasks/screenshot/ShownScene.h>

#include <cstdint>
#include <string>

namespace ticker::tasks::screenshot {

/// The reason why the code does not repeat its renders, so that a differing picture of this size
/// proves nothing. With one seed, the pixels must be equal to the last bit in another process, with
/// two threads instead of one, and with the picture's parts in another order; with another seed,
/// equal up to noise. So neither a data race nor points that are drawn anew in each process, or
/// once for all pixels, count against a picture.
/// @return  Words that continue a sentence after a colon; empty if the code repeats itself.
[[nodiscard]] std::string whyNotRepeated(const Scene& scene, int width, int height,
                                         std::uint64_t seed);

}  // namespace ticker::tasks::screenshot

#endif
