#ifndef TICKER_TASKS_SUPPORT_CHANNELS_H
#define TICKER_TASKS_SUPPORT_CHANNELS_H

#include <raytracer/image/ColourRGB.h>

#include <algorithm>

namespace ticker::tasks {

[[nodiscard]] inline double largestChannel(const raytracer::ColourRGB& colour) {
    return std::max({colour.r, colour.g, colour.b});
}

}  // namespace ticker::tasks

#endif
