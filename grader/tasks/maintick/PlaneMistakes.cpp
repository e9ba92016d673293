#include <grader/tasks/maintick/Hits.h>
#include <grader/tasks/maintick/MainTickFindings.h>

namespace ticker::tasks::maintick {
namespace {

/// s = height / slope.
struct Fraction {
    double height = 0.0;    ///< (Q - O).N
    double slope = 0.0;     ///< D.N
    double ofPoint = 0.0;   ///< Q.N
    double ofOrigin = 0.0;  ///< O.N
    double ofFirst = 0.0;   ///< Q.N with both Q and N of the first plane
    double atFirst = 0.0;   ///< Q.N with Q of the first plane and N of this one

    [[nodiscard]] double s() const { return height / slope; }
    /// The right distance; a miss unless `holds`.
    [[nodiscard]] Distance hitIf(bool holds) const { return holds ? ifAhead(s()) : Distance{}; }
};
using F = Fraction;

template <auto Solve>
Distance met(const raytracer::SceneDescription& scene, int object, const Ray& ray) {
    const auto& plane = scene.planes[static_cast<std::size_t>(object)];
    const Vector3 normal = plane.normal.normalised();
    const auto& first = scene.planes[0];
    return Solve(Fraction{(plane.point - ray.origin).dot(normal), ray.direction.dot(normal),
                          plane.point.dot(normal), ray.origin.dot(normal),
                          first.point.dot(first.normal.normalised()), first.point.dot(normal)});
}

Distance planeBeforeCamera(const raytracer::SceneDescription& scene, int object, const Ray& ray) {
    return ifBeforeCamera(ray, met<[](const F& f) { return ifAhead(f.s()); }>(scene, object, ray));
}

template <unsigned Coordinates>
Distance planeUnlessStill(const raytracer::SceneDescription& scene, int object, const Ray& ray) {
    return unlessStill(Coordinates, ray,
                       met<[](const F& f) { return ifAhead(f.s()); }>(scene, object, ray));
}

/// The distance if the normal were this axis.
template <double Vector3::*Coordinate>
Distance alongAxis(const raytracer::SceneDescription& scene, int object, const Ray& ray) {
    const auto& plane = scene.planes[static_cast<std::size_t>(object)];
    const double slope = ray.direction.*Coordinate;
    if (slope == 0.0) return {};
    return ifAhead((plane.point.*Coordinate - ray.origin.*Coordinate) / slope);
}

/// The distance if the normal were the axis that it is nearest to.
Distance alongNearestAxis(const raytracer::SceneDescription& scene, int object, const Ray& ray) {
    const Vector3& N = scene.planes[static_cast<std::size_t>(object)].normal;
    const double x = std::abs(N.x);
    const double y = std::abs(N.y);
    const double z = std::abs(N.z);
    if (y >= std::max(x, z)) return alongAxis<&Vector3::y>(scene, object, ray);
    return x >= z ? alongAxis<&Vector3::x>(scene, object, ray)
                  : alongAxis<&Vector3::z>(scene, object, ray);
}

/// The right distance, but no hit far from the plane's point.
Distance withRim(const raytracer::SceneDescription& scene, int object, const Ray& ray) {
    constexpr double kWithin = 4.0;
    const auto distance = met<[](const F& f) { return ifAhead(f.s()); }>(scene, object, ray);
    const Vector3& point = scene.planes[static_cast<std::size_t>(object)].point;
    const bool isWithin =
        distance && (ray.origin + ray.direction * *distance - point).magnitude() < kWithin;
    return isWithin ? distance : Distance{};
}

constexpr const char* kOneCoordinate =
    "One coordinate alone is used here, as in (Q.y - O.y) / D.y. That is right only where the "
    "normal is exactly that axis, and not for a plane that leans a little: take s = (Q - O).N / "
    "D.N for every plane.";
constexpr const char* kNearPlaneLimit =
    "A limit cuts near hits off: every positive s is a hit, however small it is.";
constexpr const char* kHeightLimit =
    "A limit cuts hits off where the ray starts near the plane: every positive s is a hit, however "
    "small it is, and however near the origin is to the plane.";
constexpr const char* kFirstPoint =
    "The point of another plane is used here: a static or global variable keeps the first. Work "
    "everything out in each call.";

constexpr HitMistake kPlaneMistakes[] = {
    {&kPlaneDistance, met<[](const F& f) { return ifAhead(-f.s()); }>,
     "The sign is wrong: s = (Q - O).N / D.N, from the origin of the ray to the plane."},
    {&kPlaneDistance, met<[](const F& f) { return ifAhead(f.ofPoint / f.slope); }>,
     "The origin of the ray is left out: s = (Q - O).N / D.N."},
    {&kPlaneDistance, met<[](const F& f) { return ifAhead((f.ofPoint + f.ofOrigin) / f.slope); }>,
     "O is added instead of subtracted: s = (Q - O).N / D.N."},
    {&kPlaneDistance, met<[](const F& f) { return ifAhead(-f.ofOrigin / f.slope); }>,
     "The point of the plane is left out: s = (Q - O).N / D.N."},
    {&kPlaneDistance, met<[](const F& f) { return ifAhead(f.height); }>,
     "The division by D.N is missing: s = (Q - O).N / D.N."},
    {&kPlaneDistance, met<[](const F& f) { return ifAhead(f.slope / f.height); }>,
     "The fraction is upside down: s = (Q - O).N / D.N."},
    {&kPlaneDistance, met<[](const F& f) { return ifAhead(f.slope * f.height); }>,
     "It is multiplied where it should be divided: s = (Q - O).N / D.N."},
    {&kPlaneBehind, met<[](const F& f) { return Distance{f.s()}; }>},
    {&kPlaneBehind, met<[](const F& f) { return Distance{std::abs(f.s())}; }>,
     "The absolute value brings what lies behind the ray before it: leave it out, and return "
     "std::nullopt where s is negative."},
    {&kPlaneBehind, met<[](const F& f) { return f.s() < 0.0 ? Distance{f.s()} : Distance{}; }>,
     "The test is the wrong way round: a positive s is a hit."},
    {&kPlaneOneSided, met<[](const F& f) { return f.hitIf(f.slope < 0.0); }>},
    {&kPlaneOneSided, met<[](const F& f) { return f.hitIf(0.0 < f.slope); }>},
    {&kPlaneOneSided, met<[](const F& f) { return f.slope < 0.0 ? Distance{f.s()} : Distance{}; }>},
    {&kPlaneOneSided, met<[](const F& f) { return ifAhead(f.height / std::abs(f.slope)); }>,
     "The absolute value of D.N loses the side that the ray comes from: leave it out."},
    {&kPlaneDistance,
     met<[](const F& f) { return 0.0 < f.s() ? Distance{std::abs(f.height)} : Distance{}; }>,
     "That is how far the origin is from the plane. The distance is s, along the ray: s = (Q - "
     "O).N / D.N."},
    {&kPlaneDistance, met<[](const F& f) { return ifAhead((f.ofFirst - f.ofOrigin) / f.slope); }>,
     kFirstPoint},
    {&kPlaneDistance, met<[](const F& f) { return ifAhead((f.atFirst - f.ofOrigin) / f.slope); }>,
     kFirstPoint},
    {&kPlaneMissed, planeBeforeCamera, kBehindCameraHint},
    {&kPlaneMissed, met<[](const F& f) { return f.hitIf(f.s() <= 1000.0); }>,
     "A limit cuts far hits off: every positive s is a hit, however large it is."},
    {&kPlaneMissed, met<[](const F& f) { return f.hitIf(0.01 <= std::abs(f.slope)); }>,
     "A tolerance of D.N cuts floors off before the horizon: leave rays out only where D.N is 0, "
     "or below 1e-6."},
    {&kPlaneMissed, met<[](const F& f) { return f.hitIf(0.05 <= f.s()); }>, kNearPlaneLimit},
    {&kPlaneMissed, met<[](const F& f) { return f.hitIf(0.01 <= f.s()); }>, kNearPlaneLimit},
    {&kPlaneMissed, met<[](const F& f) { return f.hitIf(0.02 <= std::abs(f.height)); }>,
     kHeightLimit},
    {&kPlaneMissed, met<[](const F& f) { return f.hitIf(0.001 <= std::abs(f.height)); }>,
     kHeightLimit},
    {&kPlaneMissed, withRim,
     "A plane has no rim: point() is one point of it, and the hit may lie as far from it as it "
     "likes.",
     true},
    {&kPlaneMissed, planeUnlessStill<1U>, kStillHint, true},
    {&kPlaneMissed, planeUnlessStill<2U>, kStillHint, true},
    {&kPlaneMissed, planeUnlessStill<4U>, kStillHint, true},
    {&kPlaneMissed, planeUnlessStill<3U>, kStillHint, true},
    {&kPlaneMissed, planeUnlessStill<5U>, kStillHint, true},
    {&kPlaneMissed, planeUnlessStill<6U>, kStillHint, true},
    {&kPlaneDistance, alongAxis<&Vector3::x>, kOneCoordinate, true},
    {&kPlaneDistance, alongAxis<&Vector3::y>, kOneCoordinate, true},
    {&kPlaneDistance, alongAxis<&Vector3::z>, kOneCoordinate, true},
    {&kPlaneDistance, alongNearestAxis, kOneCoordinate, true},
};

}  // namespace

std::span<const HitMistake> planeMistakes() {
    return kPlaneMistakes;
}

}  // namespace ticker::tasks::maintick
