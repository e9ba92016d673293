#ifndef TICKER_TESTS_TASKS_LENS_LENSBYHAND_H
#define TICKER_TESTS_TASKS_LENS_LENSBYHAND_H

#include <grader/tasks/lens/checks/LensChecks.h>
#include <grader/tests/tasks/support/InFinding.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace ticker::tasks {

/// A log of lens rays that tests fill themselves, at the handout's settings.
struct LensByHand {
    probe::RenderQuestion asked;
    LensLog log;

    LensByHand() { log.asked = &asked; }
    LensByHand(const LensByHand&) = delete;
    LensByHand& operator=(const LensByHand&) = delete;
    ~LensByHand() = default;

    /// Another pixel, whose camera ray goes along `pinhole`.
    LensPixel& pixel(const Vector3& pinhole = {0.0, 0.0, 1.0}) {
        log.pixels.emplace_back();
        log.pixels.back().pinhole = pinhole.normalised();
        return log.pixels.back();
    }
};

/// A ray from `origin` through `target`.
inline LensRay rayThrough(const Vector3& origin, const Vector3& target) {
    LensRay ray;
    ray.origin = origin;
    ray.direction = (target - origin).normalised();
    return ray;
}

}  // namespace ticker::tasks

#endif
