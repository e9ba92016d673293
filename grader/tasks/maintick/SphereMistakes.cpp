#include <grader/tasks/maintick/MainTickFindings.h>
#include <grader/tasks/maintick/SphereMistakes.h>

#include <array>
#include <limits>

namespace ticker::tasks::maintick {
namespace {

using raytracer::SceneDescription;
using Distance = std::optional<double>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The quadratic of a sphere and a ray with a direction of length 1.
struct Quadratic {
    double b = 0.0;
    double c = 0.0;
    double a = 1.0;

    [[nodiscard]] double discriminant() const { return b * b - 4.0 * a * c; }
    [[nodiscard]] double near() const { return (-b - std::sqrt(discriminant())) / (2.0 * a); }
    [[nodiscard]] double far() const { return (-b + std::sqrt(discriminant())) / (2.0 * a); }
    /// The right choice of a root.
    [[nodiscard]] Distance hit() const {
        if (discriminant() < 0.0) return {};
        const double distance = near() > 0.0 ? near() : far();
        return distance > 0.0 ? Distance{distance} : Distance{};
    }
};

Quadratic quadraticOf(const SceneDescription& scene, int object, const Ray& ray) {
    const auto& sphere = scene.spheres[static_cast<std::size_t>(object)];
    const Vector3 from = ray.origin - sphere.centre;
    return {2.0 * ray.direction.dot(from), from.dot(from) - sphere.radius * sphere.radius};
}

double radiusOf(const SceneDescription& scene, int object) {
    return scene.spheres[static_cast<std::size_t>(object)].radius;
}

Distance ifAhead(double distance) {
    return distance > 0.0 ? Distance{distance} : Distance{};
}

/// A mistake in the choice of the root.
template <auto Choose>
Distance chosen(const SceneDescription& scene, int object, const Ray& ray) {
    const Quadratic q = quadraticOf(scene, object, ray);
    return q.discriminant() < 0.0 ? Distance{} : Choose(q);
}

/// A mistake in the coefficients.
template <auto Change>
Distance changed(const SceneDescription& scene, int object, const Ray& ray) {
    const double r = radiusOf(scene, object);
    return Change(quadraticOf(scene, object, ray), r).hit();
}

double smaller(const Quadratic& q) {
    return std::abs(q.near()) < std::abs(q.far()) ? q.near() : q.far();
}

/// Code that leaves hits out where the handout has no limit.
template <auto IsLeftOut>
Distance limited(const SceneDescription& scene, int object, const Ray& ray) {
    const Quadratic q = quadraticOf(scene, object, ray);
    return IsLeftOut(q) ? Distance{} : q.hit();
}

/// A radius that is worked out once and kept, or taken from another sphere.
Distance firstRadius(const SceneDescription& scene, int object, const Ray& ray) {
    const double own = radiusOf(scene, object);
    const double kept = radiusOf(scene, 0);
    Quadratic q = quadraticOf(scene, object, ray);
    q.c += own * own - kept * kept;
    return q.hit();
}
Distance distanceOfLocation(const SceneDescription& scene, int object, const Ray& ray) {
    const Distance right = quadraticOf(scene, object, ray).hit();
    return right ? Distance{ray.evaluateAt(*right).magnitude()} : right;
}
Distance withoutOrigin(const SceneDescription& scene, int object, const Ray& ray) {
    return quadraticOf(scene, object, {{}, ray.direction}).hit();
}
Distance absoluteDiscriminant(const SceneDescription& scene, int object, const Ray& ray) {
    Quadratic q = quadraticOf(scene, object, ray);
    const double root = std::sqrt(std::abs(q.discriminant()));
    const double near = (-q.b - root) / 2.0;
    return ifAhead(near > 0.0 ? near : (-q.b + root) / 2.0);
}
Distance notANumber(const SceneDescription& scene, int object, const Ray& ray) {
    const Quadratic q = quadraticOf(scene, object, ray);
    return q.discriminant() < 0.0 ? Distance{kNaN} : q.hit();
}
Distance withoutDivision(const SceneDescription& scene, int object, const Ray& ray) {
    const Distance right = quadraticOf(scene, object, ray).hit();
    return right ? Distance{2.0 * *right} : right;
}

constexpr const char* kSmallerRoot =
    "From inside one root is negative and lies behind the ray, however small it is: look at signs, "
    "not at sizes. Take (-b - root) / (2 a) where it is positive, else (-b + root) / (2 a).";
constexpr const char* kNoFarRoot =
    "Where (-b - root) / (2 a) is not positive, the ray may start inside: try (-b + root) / (2 a) "
    "before you give up.";

constexpr std::array kSphereMistakes{
    HitMistake{&kSphereFarRoot, "", chosen<[](const Quadratic& q) { return ifAhead(q.far()); }>},
    HitMistake{&kSphereInside, kNoFarRoot,
               chosen<[](const Quadratic& q) { return ifAhead(q.near()); }>},
    HitMistake{&kSphereInside, kSmallerRoot,
               chosen<[](const Quadratic& q) { return ifAhead(smaller(q)); }>},
    HitMistake{&kSphereInside, kSmallerRoot, chosen<[](const Quadratic& q) {
                   return 0.0 < q.far() ? Distance{std::abs(smaller(q))} : Distance{};
               }>},
    HitMistake{
        &kSphereInside, kSmallerRoot,
        chosen<[](const Quadratic& q) { return 0.0 < q.far() ? Distance{q.near()} : Distance{}; }>},
    HitMistake{&kSphereBehind, "", chosen<[](const Quadratic& q) { return Distance{q.near()}; }>},
    HitMistake{&kSphereBehind, "",
               chosen<[](const Quadratic& q) { return Distance{std::abs(smaller(q))}; }>},
    HitMistake{&kSphereBehind, "",
               chosen<[](const Quadratic& q) { return Distance{std::abs(q.near())}; }>},
    HitMistake{&kSphereBehind, "", chosen<[](const Quadratic& q) { return Distance{smaller(q)}; }>},
    HitMistake{
        &kSphereBehind, "",
        chosen<[](const Quadratic& q) { return Distance{0.0 < q.near() ? q.near() : q.far()}; }>},
    HitMistake{&kSpherePhantom,
               "The absolute value of a negative discriminant makes hits of misses: return "
               "std::nullopt there.",
               absoluteDiscriminant},
    HitMistake{&kSpherePhantom, "", notANumber},
    HitMistake{&kSphereDistance,
               "b needs its factor 2: b = 2 D.(O - C), as the formula divides by 2 a.",
               changed<[](Quadratic q, double) {
                   q.b /= 2.0;
                   return q;
               }>},
    HitMistake{&kSphereDistance,
               "The radius is squared in c: c = (O - C).(O - C) - radius() * radius().",
               changed<[](Quadratic q, double r) {
                   q.c += r * r - r;
                   return q;
               }>},
    HitMistake{&kSphereDistance, "c lacks the radius: c = (O - C).(O - C) - radius() * radius().",
               changed<[](Quadratic q, double r) {
                   q.c += r * r;
                   return q;
               }>},
    HitMistake{&kSphereDistance, "The squared radius is subtracted in c, not added.",
               changed<[](Quadratic q, double r) {
                   q.c += 2.0 * r * r;
                   return q;
               }>},
    HitMistake{
        &kSphereDistance,
        "The sign of b is wrong: it is 2 D.(O - C), from the centre to the origin of the ray, "
        "and the roots begin with -b.",
        changed<[](Quadratic q, double) {
            q.b = -q.b;
            return q;
        }>},
    HitMistake{&kSphereDistance,
               "The origin of the ray is left out: b and c are made of O - C, not of C alone.",
               withoutOrigin},
    HitMistake{&kSphereDistance, "The discriminant is b * b - 4 a c: the 4 is left out.",
               [](const SceneDescription& scene, int object, const Ray& ray) {
                   Quadratic q = quadraticOf(scene, object, ray);
                   const double inside = q.b * q.b - q.c;
                   if (inside < 0.0) return Distance{};
                   const double near = (-q.b - std::sqrt(inside)) / 2.0;
                   return ifAhead(near > 0.0 ? near : (-q.b + std::sqrt(inside)) / 2.0);
               }},
    HitMistake{&kSphereDistance, "The roots are divided by 2 a, not by a: (-b - root) / (2 * a).",
               withoutDivision},
    HitMistake{&kSphereDistance,
               "That is the point of the ray that is nearest to the centre: the root of the "
               "discriminant is missing, (-b - std::sqrt(discriminant)) / (2 a).",
               chosen<[](const Quadratic& q) { return ifAhead(-q.b / 2.0); }>},
    HitMistake{
        &kSphereDistance,
        "That is how far the hit is from the origin of the world. The distance is s, along the "
        "ray: a shadow ray or a mirrored one starts elsewhere.",
        distanceOfLocation},
    HitMistake{&kSphereDistance,
               "The radius of another sphere is used here: a static or global variable keeps the "
               "first. Work everything out in each call.",
               firstRadius},
    HitMistake{&kSphereMissed,
               "A limit cuts far hits off: every positive s is a hit, however large it is.",
               limited<[](const Quadratic& q) { return Distance{1000.0} < q.hit(); }>},
    HitMistake{
        &kSphereMissed,
        "A limit cuts near hits off: every positive s is a hit, however small it is.",
        chosen<[](const Quadratic& q) { return ifAhead(0.05 < q.near() ? q.near() : q.far()); }>},
    HitMistake{&kSphereMissed,
               "A tolerance of the discriminant takes small spheres and the rims of others away: "
               "only where it is negative there is no hit.",
               limited<[](const Quadratic& q) { return q.discriminant() < 4e-3; }>},
};

}  // namespace

std::span<const HitMistake> sphereMistakes() {
    return kSphereMistakes;
}

}  // namespace ticker::tasks::maintick
