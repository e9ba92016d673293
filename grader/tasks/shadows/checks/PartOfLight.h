#ifndef TICKER_TASKS_SHADOWS_CHECKS_PARTOFLIGHT_H
#define TICKER_TASKS_SHADOWS_CHECKS_PARTOFLIGHT_H

#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <cstddef>
#include <optional>

namespace ticker::tasks {

/// How many rays to the only light arrive, and which part of its light the point has.
struct PartOfLight {
    std::size_t open = 0;
    std::size_t cast = 0;
    double part = 0.0;

    [[nodiscard]] double share() const {
        return static_cast<double>(open) / static_cast<double>(cast);
    }
};

/// Empty if rounding decides, or if diffuse and specular light have different parts.
[[nodiscard]] std::optional<PartOfLight> partOfLight(const PointLog& point, const ShadowLog& log);

}  // namespace ticker::tasks

#endif
