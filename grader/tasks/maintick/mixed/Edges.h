#ifndef TICKER_TASKS_MAINTICK_MIXED_EDGES_H
#define TICKER_TASKS_MAINTICK_MIXED_EDGES_H

#include <grader/tasks/maintick/PhongModel.h>
#include <grader/tasks/support/Surfaces.h>

namespace ticker::tasks::maintick {

/// Distance from an edge, world units, beyond which a result is certain. It may grow along a ray,
/// since a ray that leaves a curved mirror turns if its start moves.
struct Margin {
    double least = 0.012;
    double spread = 0.0;  ///< for each unit along the ray
};

/// What a ray meets of one object before `reach`; `unsure` near a tangent or either end, where the
/// bias or rounding could decide.
/// @param ray    Its direction has length 1.
/// @param reach  Infinity: the whole ray.
[[nodiscard]] Sight sightOf(const raytracer::SphereDescription& sphere, const Ray& ray,
                            double reach, const Margin& margin = {});
[[nodiscard]] Sight sightOf(const raytracer::PlaneDescription& plane, const Ray& ray, double reach,
                            const Margin& margin = {});

/// The same for all objects but one; `unsure` if any of them is.
/// @param without  An index: spheres first, then planes.
[[nodiscard]] Sight sightOf(const raytracer::SceneDescription& scene, const Ray& ray, double reach,
                            int without, const Margin& margin = {});

/// The ray from the point towards a light; its direction has length 1.
[[nodiscard]] Ray wayTo(const LitSetup& setup, const raytracer::PointLight& light);

/// N.L
[[nodiscard]] double facingOf(const LitSetup& setup, const raytracer::PointLight& light);

/// Whether N.V, N.L and R.V are all well away from 0, and R.V is negative for each light behind the
/// surface: accepted readings differ in whether such a light has a highlight.
[[nodiscard]] bool isOffEdges(const LitSetup& setup);

/// Whether single precision, with the largest rounding error in each step, changes the colour by at
/// most half the tolerance.
[[nodiscard]] bool isRightInFloats(const LitSetup& setup);

}  // namespace ticker::tasks::maintick

#endif
