#ifndef TICKER_TASKS_MAINTICK_MIXED_EDGES_H
#define TICKER_TASKS_MAINTICK_MIXED_EDGES_H

#include <grader/tasks/maintick/PhongModel.h>
#include <grader/tasks/support/Surfaces.h>

namespace ticker::tasks::maintick {

/// How far from an edge is sure. A ray that leaves a curved mirror turns along with its start.
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

/// Of all objects but one. `unsure` if one of them is.
/// @param without  An index: spheres first, then planes.
[[nodiscard]] Sight sightOf(const raytracer::SceneDescription& scene, const Ray& ray, double reach,
                            int without, const Margin& margin = {});

/// From the point to one of its lights, and on for `reach` in place of the light's distance.
[[nodiscard]] Ray wayTo(const LitSetup& setup, const raytracer::PointLight& light);

/// N.L
[[nodiscard]] double facingOf(const LitSetup& setup, const raytracer::PointLight& light);

/// Whether all cosines are off their edges, and R.V is negative for each light behind the surface:
/// readings differ in whether such a light has a highlight.
[[nodiscard]] bool isOffEdges(const LitSetup& setup);

/// Whether the worst that single precision makes of each step moves the colour by less than half
/// the tolerance.
[[nodiscard]] bool isRightInFloats(const LitSetup& setup);

}  // namespace ticker::tasks::maintick

#endif
