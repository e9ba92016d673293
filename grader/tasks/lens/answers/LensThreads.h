#ifndef TICKER_TASKS_LENS_ANSWERS_LENSTHREADS_H
#define TICKER_TASKS_LENS_ANSWERS_LENSTHREADS_H

#include <grader/probe/Question.h>
#include <grader/tasks/lens/answers/LensLog.h>

#include <cstddef>
#include <vector>

namespace ticker::tasks {

/// A lens ray with the possible indices of its pixel in the picture; -1 for an unknown index.
struct PlacedRay {
    LensRay ray;
    bool untraced = false;  // the scene was asked about it, and it hit nothing
    int repetition = 0;
    int bySet = -1;
    int byCamera = -1;
    bool byHelper = false;  // its thread set no pixel
};

struct ReadRays {
    std::vector<PlacedRay> entered;  // traced, or not traced because they hit nothing
    std::vector<PlacedRay> cast;  // the scene was asked about them, and they were not traced next
};

/// The lens rays of all threads of all repetitions, from the log of a render.
[[nodiscard]] ReadRays readThreads(const probe::RenderQuestion& asked,
                                   const std::vector<probe::Event>& events);

/// How the threads of a render met.
struct ThreadsMet {
    bool several = false;         ///< more than one thread traced rays
    std::size_t interrupted = 0;  ///< times that another thread did something while one had traced
                                  ///< rays of a pixel and not set it
};
/// @param events  Of one repetition.
[[nodiscard]] ThreadsMet threadsMet(const std::vector<probe::Event>& events);

}  // namespace ticker::tasks

#endif
