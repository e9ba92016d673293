#include <grader/tasks/maintick/Hits.h>
#include <grader/tasks/maintick/MainTickFindings.h>

#include <limits>

namespace ticker::tasks::maintick {
namespace {

using raytracer::SceneDescription;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The quadratic of a sphere and a ray with a direction of length 1: a is 1.
struct Quadratic {
    double b = 0.0;
    double c = 0.0;
    double radius = 0.0;
    double firstRadius = 0.0;  ///< of the scene's first sphere

    [[nodiscard]] double discriminant() const { return b * b - 4.0 * c; }
    [[nodiscard]] bool isMissed() const { return discriminant() < 0.0; }
    [[nodiscard]] double near() const { return (-b - std::sqrt(discriminant())) / 2.0; }
    [[nodiscard]] double far() const { return (-b + std::sqrt(discriminant())) / 2.0; }
    [[nodiscard]] double smaller() const {
        return std::abs(near()) < std::abs(far()) ? near() : far();
    }
    /// The right choice of a root.
    [[nodiscard]] Distance hit() const {
        return isMissed() ? Distance{} : firstAhead(near(), far());
    }
    [[nodiscard]] static Distance firstAhead(double first, double second) {
        return ifAhead(first > 0.0 ? first : second);
    }
    [[nodiscard]] Distance hitWith(double otherB, double otherC) const {
        return Quadratic{otherB, otherC}.hit();
    }
};
using Q = Quadratic;

Quadratic quadraticOf(const SceneDescription& scene, int object, const Ray& ray) {
    const auto& sphere = scene.spheres[static_cast<std::size_t>(object)];
    const Vector3 from = ray.origin - sphere.centre;
    return {2.0 * ray.direction.dot(from), from.dot(from) - sphere.radius * sphere.radius,
            sphere.radius, scene.spheres[0].radius};
}

template <auto Solve>
Distance solved(const SceneDescription& scene, int object, const Ray& ray) {
    return Solve(quadraticOf(scene, object, ray));
}

/// What code answers that computes the quadratic rightly and chooses a wrong root.
template <auto Choose>
Distance chosen(const SceneDescription& scene, int object, const Ray& ray) {
    const Quadratic q = quadraticOf(scene, object, ray);
    return q.isMissed() ? Distance{} : Choose(q);
}

Distance distanceOfLocation(const SceneDescription& scene, int object, const Ray& ray) {
    const Distance right = quadraticOf(scene, object, ray).hit();
    return right ? Distance{ray.evaluateAt(*right).magnitude()} : right;
}
Distance withoutOrigin(const SceneDescription& scene, int object, const Ray& ray) {
    return quadraticOf(scene, object, {{}, ray.direction}).hit();
}

Distance sphereBeforeCamera(const SceneDescription& scene, int object, const Ray& ray) {
    return ifBeforeCamera(ray, quadraticOf(scene, object, ray).hit());
}

template <unsigned Coordinates>
Distance sphereUnlessStill(const SceneDescription& scene, int object, const Ray& ray) {
    return unlessStill(Coordinates, ray, quadraticOf(scene, object, ray).hit());
}

constexpr const char* kSmallerRoot =
    "From inside one root is negative and lies behind the ray, however small it is: look at signs, "
    "not at sizes. Take (-b - root) / (2 a) where it is positive, else (-b + root) / (2 a).";
constexpr const char* kNoFarRoot =
    "Where (-b - root) / (2 a) is not positive, the ray may start inside: try (-b + root) / (2 a) "
    "before you give up.";

constexpr const char* kNeitherTested =
    "A negative distance lies behind the ray, however small it is. Take (-b - root) / (2 a) where "
    "it is positive, else (-b + root) / (2 a), and return std::nullopt where neither is.";
constexpr const char* kAbsoluteRoot =
    "The absolute value brings what lies behind the ray before it: leave it out. Take (-b - root) "
    "/ (2 a) where it is positive, else (-b + root) / (2 a), and return std::nullopt where neither "
    "is.";
constexpr const char* kRootMissing =
    "That is the point of the ray that is nearest to the centre: the root of the discriminant is "
    "missing, (-b - std::sqrt(discriminant)) / (2 a).";

constexpr const char* kLimitBelowZero =
    "A limit below 0 takes a near root that lies a little behind the ray, as that of a ray that "
    "starts just inside: compare (-b - root) / (2 a) with 0, and (-b + root) / (2 a) as well, "
    "however large the sphere.";

constexpr double kNearest = 0.05;
constexpr const char* kNearLimit =
    "A limit cuts near hits off: every positive s is a hit, however small it is, and however large "
    "the sphere.";

/// The limit of code that also takes hits a little behind the origin of the ray, world units.
constexpr double kBehind = -0.05;
double nearRootBehind(const Q& q) {
    return kBehind < q.near() ? q.near() : q.far();
}

constexpr HitMistake kSphereMistakes[] = {
    {&kSphereFarRoot, chosen<[](const Q& q) { return ifAhead(q.far()); }>},
    {&kSphereInside, chosen<[](const Q& q) { return ifAhead(q.near()); }>, kNoFarRoot},
    {&kSphereInside, chosen<[](const Q& q) { return ifAhead(q.smaller()); }>, kSmallerRoot},
    {&kSphereInside, chosen<[](const Q& q) {
         return 0.0 < q.far() ? Distance{std::abs(q.smaller())} : Distance{};
     }>,
     kSmallerRoot},
    {&kSphereInside,
     chosen<[](const Q& q) { return 0.0 < q.far() ? Distance{q.near()} : Distance{}; }>,
     kSmallerRoot},
    {&kSphereInside, chosen<[](const Q& q) { return ifAhead(nearRootBehind(q)); }>, kLimitBelowZero,
     true},
    {&kSphereInside, chosen<[](const Q& q) {
         return kBehind < nearRootBehind(q) ? Distance{nearRootBehind(q)} : Distance{};
     }>,
     kLimitBelowZero},
    {&kSphereInside,
     chosen<[](const Q& q) { return kBehind < q.near() ? Distance{q.near()} : ifAhead(q.far()); }>,
     kLimitBelowZero, true},
    {&kSphereBehind, chosen<[](const Q& q) {
         if (0.0 < q.near()) return Distance{q.near()};
         return kBehind < q.far() ? Distance{q.far()} : Distance{};
     }>,
     "A limit below 0 takes a far side that lies a little behind the ray: compare (-b + root) / (2 "
     "a) with 0.",
     true},
    {&kSphereBehind, chosen<[](const Q& q) { return Distance{q.near()}; }>, kNeitherTested},
    {&kSphereBehind, chosen<[](const Q& q) { return Distance{std::abs(q.smaller())}; }>,
     kAbsoluteRoot},
    {&kSphereBehind, chosen<[](const Q& q) { return Distance{std::abs(q.near())}; }>,
     kAbsoluteRoot},
    {&kSphereBehind, chosen<[](const Q& q) { return Distance{q.smaller()}; }>, kNeitherTested},
    {&kSphereBehind,
     chosen<[](const Q& q) { return Distance{0.0 < q.near() ? q.near() : q.far()}; }>},
    {&kSpherePhantom, solved<[](const Q& q) {
         return q.hitWith(q.b, (q.b * q.b - std::abs(q.discriminant())) / 4.0);
     }>,
     "The absolute value of a negative discriminant makes hits of misses: return std::nullopt "
     "there."},
    {&kSpherePhantom, solved<[](const Q& q) { return q.isMissed() ? Distance{kNaN} : q.hit(); }>},
    {&kSphereDistance, solved<[](const Q& q) { return q.hitWith(q.b / 2.0, q.c); }>,
     "b needs its factor 2: b = 2 D.(O - C), as the formula divides by 2 a."},
    {&kSphereDistance,
     solved<[](const Q& q) { return q.hitWith(q.b, q.c + q.radius * q.radius - q.radius); }>,
     "The radius is squared in c: c = (O - C).(O - C) - radius() * radius()."},
    {&kSphereDistance, solved<[](const Q& q) { return q.hitWith(q.b, q.c + q.radius * q.radius); }>,
     "No ray hits, as if c lacked the radius: c = (O - C).(O - C) - radius() * radius(). If "
     "the radius is there, look at O - C (ray.origin - centre(), in b and in c), then at the "
     "discriminant, b * b - 4 a c, and at what is returned."},
    {&kSphereDistance,
     solved<[](const Q& q) { return q.hitWith(q.b, q.c + 2.0 * q.radius * q.radius); }>,
     "The squared radius is subtracted in c, not added."},
    {&kSphereDistance, solved<[](const Q& q) { return q.hitWith(-q.b, q.c); }>,
     "The sign of b is wrong: it is 2 D.(O - C), from the centre to the origin of the ray, and the "
     "roots begin with -b."},
    {&kSphereDistance, withoutOrigin,
     "The origin of the ray is left out: b and c are made of O - C, not of C alone."},
    {&kSphereDistance, solved<[](const Q& q) { return q.hitWith(q.b, q.c / 4.0); }>,
     "The discriminant is b * b - 4 a c: the 4 is left out."},
    {&kSphereDistance,
     solved<[](const Q& q) { return q.hit() ? Distance{2.0 * *q.hit()} : Distance{}; }>,
     "The roots are divided by 2 a, not by a: (-b - root) / (2 * a)."},
    {&kSphereDistance, chosen<[](const Q& q) { return ifAhead(-q.b / 2.0); }>, kRootMissing},
    {&kSphereDistance, chosen<[](const Q& q) { return Q::firstAhead(-q.b / 2.0, q.far()); }>,
     kRootMissing},
    {&kSphereDistance, chosen<[](const Q& q) {
         const double root = q.discriminant();
         return Q::firstAhead((-q.b - root) / 2.0, (-q.b + root) / 2.0);
     }>,
     "The square root is missing: root = std::sqrt(b * b - 4 a c), and the distance is (-b - root) "
     "/ (2 a)."},
    {&kSphereDistance,
     solved<[](const Q& q) { return q.hit() ? Distance{*q.hit() * *q.hit()} : Distance{}; }>,
     "That is the square of the distance: hand s itself to RaycastHit."},
    {&kSphereDistance, distanceOfLocation,
     "That is how far the hit is from the origin of the world. The distance is s, along the ray: a "
     "shadow ray or a mirrored one starts elsewhere."},
    {&kSphereDistance, solved<[](const Q& q) {
         return q.hitWith(q.b, q.c + q.radius * q.radius - q.firstRadius * q.firstRadius);
     }>,
     "The radius of another sphere is used here: a static or global variable keeps the first. Work "
     "everything out in each call."},
    {&kSphereMissed, chosen<[](const Q& q) {
         return 1.0 <= q.near()  ? Distance{q.near()}
                : 1.0 <= q.far() ? Distance{q.far()}
                                 : Distance{};
     }>,
     "Hits nearer than 1 count as well: the image plane is no limit, and most rays do not start at "
     "the camera."},
    {&kSphereMissed, sphereBeforeCamera, kBehindCameraHint},
    {&kSphereMissed,
     solved<[](const Q& q) { return Distance{1000.0} < q.hit() ? Distance{} : q.hit(); }>,
     "A limit cuts far hits off: every positive s is a hit, however large it is."},
    {&kSphereMissed,
     chosen<[](const Q& q) { return ifAhead(kNearest < q.near() ? q.near() : q.far()); }>,
     kNearLimit, true},
    {&kSphereMissed,
     solved<[](const Q& q) { return Distance{kNearest} < q.hit() ? q.hit() : Distance{}; }>,
     kNearLimit, true},
    {&kSphereMissed, chosen<[](const Q& q) {
         if (kNearest < q.near()) return Distance{q.near()};
         return kNearest < q.far() ? Distance{q.far()} : Distance{};
     }>,
     kNearLimit, true},
    {&kSphereMissed,
     solved<[](const Q& q) { return q.discriminant() < 4e-3 ? Distance{} : q.hit(); }>,
     "A tolerance of the discriminant takes small spheres and the rims of others away: only where "
     "it is negative there is no hit.",
     true},
    {&kSphereMissed, sphereUnlessStill<1U>, kStillHint, true},
    {&kSphereMissed, sphereUnlessStill<2U>, kStillHint, true},
    {&kSphereMissed, sphereUnlessStill<4U>, kStillHint, true},
    {&kSphereMissed, sphereUnlessStill<3U>, kStillHint, true},
    {&kSphereMissed, sphereUnlessStill<5U>, kStillHint, true},
    {&kSphereMissed, sphereUnlessStill<6U>, kStillHint, true},
};

}  // namespace

std::span<const HitMistake> sphereMistakes() {
    return kSphereMistakes;
}

}  // namespace ticker::tasks::maintick
