#ifndef TICKER_TASKS_MAINTICK_EXACT_H
#define TICKER_TASKS_MAINTICK_EXACT_H

#include <grader/tasks/support/FindingOrder.h>

#include <raytracer/image/ColourRGB.h>
#include <raytracer/math/Ray.h>
#include <raytracer/scene/SceneDescription.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>

namespace ticker::tasks::maintick {

using raytracer::ColourRGB;
using raytracer::Ray;
using raytracer::Vector3;

/// Tolerance of right answers, relative to the larger of 1 and the expected value. In double
/// precision all ways to compute agree to 1e-9. In single precision they agree to 2e-4, as accepted
/// entries of the corpus show: small spheres are asked from nearby, and far ones are large. Every
/// known mistake moves some answer by more than 1e-2. The exception is a distance rounded to three
/// decimals, for which one near plane is asked with a tolerance of its own.
inline constexpr double kTolerance = 5e-4;
/// Tolerance of colours behind a mirror, whose reflected ray may start up to 1e-3 above the
/// surface.
inline constexpr double kMirrorTolerance = 4e-3;

/// Whether `a` differs from `expected` by at most `tolerance`, relative to the larger of 1 and
/// `expected`. False for NaN.
[[nodiscard]] inline bool isNear(double a, double expected, double tolerance = kTolerance) {
    return std::abs(a - expected) <= tolerance * std::max(1.0, std::abs(expected));
}
/// The same for vectors, relative to the larger of 1 and the length of `expected`.
[[nodiscard]] inline bool isNear(const Vector3& a, const Vector3& expected,
                                 double tolerance = kTolerance) {
    return isNear((a - expected).magnitude() + expected.magnitude(), expected.magnitude(),
                  tolerance);
}
/// The same for colours, relative to the largest channel of `expected`, since all its channels may
/// be small.
[[nodiscard]] inline bool isNear(const ColourRGB& a, const ColourRGB& expected,
                                 double tolerance = kTolerance) {
    const double scale =
        std::max({std::abs(expected.r), std::abs(expected.g), std::abs(expected.b), 1e-6});
    const ColourRGB d = a - expected;
    return std::abs(d.r) <= tolerance * scale && std::abs(d.g) <= tolerance * scale &&
           std::abs(d.b) <= tolerance * scale;
}

/// Where a ray meets a surface, in double precision. The distance counts in lengths of the ray's
/// direction.
struct Meeting {
    double distance = 0.0;
    Vector3 location;
    Vector3 normal;
};
/// The nearest point of the surface ahead of the ray's origin; empty if the ray misses it.
[[nodiscard]] std::optional<Meeting> meet(const raytracer::SphereDescription& sphere,
                                          const Ray& ray);
[[nodiscard]] std::optional<Meeting> meet(const raytracer::PlaneDescription& plane, const Ray& ray);

/// "(0.12, 3, -1.5)"
[[nodiscard]] std::string words(const Vector3& v);
[[nodiscard]] std::string words(const ColourRGB& c);

/// A finding that fails.
/// @param hint  Empty: that of `text`.
[[nodiscard]] Finding failure(const FindingText& text, std::string seen, std::string hint = {});

/// Index of the first answer that code with this mistake would not give; empty if the mistake
/// explains all answers.
/// @param mistake  A pointer; null stands for right code.
/// @param isRight  isRight(index, mistake): whether that answer is the one of code with the
///                 mistake.
template <class Mistake, class IsRight>
[[nodiscard]] std::optional<std::size_t> firstWrong(std::size_t questions, const Mistake& mistake,
                                                    const IsRight& isRight) {
    for (std::size_t i = 0; i < questions; ++i)
        if (!isRight(i, mistake)) return i;
    return std::nullopt;
}

/// Known mistakes are rows: the finding, what code with the mistake answers, and the hint.
/// @return  A failure by the name of the first row that explains all answers.
template <class Mistake, class IsRight>
[[nodiscard]] std::optional<Finding> nameMistake(std::span<const Mistake> mistakes,
                                                 std::size_t questions, const IsRight& isRight,
                                                 const std::string& seen) {
    for (const Mistake& mistake : mistakes)
        if (!firstWrong(questions, &mistake, isRight))
            return failure(*mistake.finding, seen, mistake.hint);
    return std::nullopt;
}

}  // namespace ticker::tasks::maintick

#endif
