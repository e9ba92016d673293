#ifndef TICKER_TASKS_SUPPORT_FINITE_H
#define TICKER_TASKS_SUPPORT_FINITE_H

#include <raytracer/math/Vector3.h>

#include <cmath>

namespace ticker::tasks {

/// True if no component is NaN or infinite.
[[nodiscard]] inline bool isFinite(const raytracer::Vector3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace ticker::tasks

#endif
