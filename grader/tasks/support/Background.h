#ifndef TICKER_TASKS_SUPPORT_BACKGROUND_H
#define TICKER_TASKS_SUPPORT_BACKGROUND_H

#include <raytracer/image/ColourRGB.h>

namespace ticker::tasks {

/// The colour of a ray that meets nothing, as the handout has it.
inline constexpr raytracer::ColourRGB kBackground{0.001};

}  // namespace ticker::tasks

#endif
