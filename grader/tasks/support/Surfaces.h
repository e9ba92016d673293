#ifndef TICKER_TASKS_SUPPORT_SURFACES_H
#define TICKER_TASKS_SUPPORT_SURFACES_H

#include <raytracer/image/ColourRGB.h>
#include <raytracer/math/Vector3.h>
#include <raytracer/scene/SceneDescription.h>

#include <vector>

namespace ticker::tasks {

using raytracer::ColourRGB;
using raytracer::Vector3;

/// Whether a ray gets through. `unsure` if rounding decides; such rays never count against a
/// submission.
enum class Sight { open, blocked, unsure };

/// Distances to the first surface on a ray, for the scene and for two variants that bound the
/// effect of rounding. Infinite if the ray meets nothing; distances within rounding of the start
/// are 0.
struct NearestHits {
    double plain = 0.0;  ///< of the scene
    double small = 0.0;  ///< if its spheres were smaller by more than rounding
    double large = 0.0;  ///< if they were larger

    /// Whether a surface lies on the ray before `reach`.
    [[nodiscard]] Sight sightUpTo(double reach) const;
};

/// The surfaces of a scene for the replay: our own intersections, in double precision. The
/// framework's are not used, because the submission could have changed their results.
class Surfaces {
public:
    explicit Surfaces(const raytracer::SceneDescription& scene);

    /// Whether a surface lies on the ray before `reach`.
    /// @param direction  Unit length.
    /// @param reach      World units; infinity: the whole ray.
    [[nodiscard]] Sight sightAlong(const Vector3& origin, const Vector3& direction,
                                   double reach) const {
        return hitsAlong(origin, direction).sightUpTo(reach);
    }

    /// For several reaches of one ray.
    /// @param direction  Unit length.
    [[nodiscard]] NearestHits hitsAlong(const Vector3& origin, const Vector3& direction) const;

    /// Distance from a point to the nearest surface, world units.
    [[nodiscard]] double distanceToNearest(const Vector3& point) const;

private:
    struct Ball {
        Vector3 centre;
        double radius;
        double square;  ///< of the radius
        double smallSquare;
        double largeSquare;
    };
    struct Sheet {
        Vector3 point;
        Vector3 normal;
    };
    std::vector<Ball> balls_;
    std::vector<Sheet> sheets_;
};

/// The material of object `index`: spheres first, then planes.
[[nodiscard]] const raytracer::Material& materialOf(const raytracer::SceneDescription& scene,
                                                    int index);

}  // namespace ticker::tasks

#endif
