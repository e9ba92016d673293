#include <grader/tasks/maintick/Hits.h>
#include <grader/tasks/maintick/JudgeMainTick.h>
#include <grader/tasks/maintick/MainTickFindings.h>
#include <grader/tasks/support/Draw.h>

#include <fmt/core.h>

#include <array>
#include <limits>

namespace ticker::tasks {
namespace {

using maintick::AskedHit;
using maintick::HitSlip;
using maintick::Place;
using raytracer::Ray;
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

/// A slip in the choice of the root.
template <auto Choose>
Distance chosen(const SceneDescription& scene, int object, const Ray& ray) {
    const Quadratic q = quadraticOf(scene, object, ray);
    return q.discriminant() < 0.0 ? Distance{} : Choose(q);
}

/// A slip in the coefficients.
template <auto Change>
Distance changed(const SceneDescription& scene, int object, const Ray& ray) {
    const double r = radiusOf(scene, object);
    return Change(quadraticOf(scene, object, ray), r).hit();
}

double smaller(const Quadratic& q) {
    return std::abs(q.near()) < std::abs(q.far()) ? q.near() : q.far();
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

constexpr std::array kSphereSlips{
    HitSlip{&kSphereFarRoot, "", chosen<[](const Quadratic& q) { return ifAhead(q.far()); }>},
    HitSlip{&kSphereInside, kNoFarRoot,
            chosen<[](const Quadratic& q) { return ifAhead(q.near()); }>},
    HitSlip{&kSphereInside, kSmallerRoot,
            chosen<[](const Quadratic& q) { return ifAhead(smaller(q)); }>},
    HitSlip{&kSphereInside, kSmallerRoot, chosen<[](const Quadratic& q) {
                return 0.0 < q.far() ? Distance{std::abs(smaller(q))} : Distance{};
            }>},
    HitSlip{
        &kSphereInside, kSmallerRoot,
        chosen<[](const Quadratic& q) { return 0.0 < q.far() ? Distance{q.near()} : Distance{}; }>},
    HitSlip{&kSphereBehind, "", chosen<[](const Quadratic& q) { return Distance{q.near()}; }>},
    HitSlip{&kSphereBehind, "",
            chosen<[](const Quadratic& q) { return Distance{std::abs(smaller(q))}; }>},
    HitSlip{&kSphereBehind, "",
            chosen<[](const Quadratic& q) { return Distance{std::abs(q.near())}; }>},
    HitSlip{&kSphereBehind, "", chosen<[](const Quadratic& q) { return Distance{smaller(q)}; }>},
    HitSlip{
        &kSphereBehind, "",
        chosen<[](const Quadratic& q) { return Distance{0.0 < q.near() ? q.near() : q.far()}; }>},
    HitSlip{&kSpherePhantom,
            "The absolute value of a negative discriminant makes hits of misses: return "
            "std::nullopt there.",
            absoluteDiscriminant},
    HitSlip{&kSpherePhantom, "", notANumber},
    HitSlip{&kSphereDistance,
            "b needs its factor 2: b = 2 D.(O - C), as the formula divides by 2 a.",
            changed<[](Quadratic q, double) {
                q.b /= 2.0;
                return q;
            }>},
    HitSlip{&kSphereDistance,
            "The radius is squared in c: c = (O - C).(O - C) - radius() * radius().",
            changed<[](Quadratic q, double r) {
                q.c += r * r - r;
                return q;
            }>},
    HitSlip{&kSphereDistance, "c lacks the radius: c = (O - C).(O - C) - radius() * radius().",
            changed<[](Quadratic q, double r) {
                q.c += r * r;
                return q;
            }>},
    HitSlip{&kSphereDistance, "The squared radius is subtracted in c, not added.",
            changed<[](Quadratic q, double r) {
                q.c += 2.0 * r * r;
                return q;
            }>},
    HitSlip{&kSphereDistance,
            "The sign of b is wrong: it is 2 D.(O - C), from the centre to the origin of the ray, "
            "and the roots begin with -b.",
            changed<[](Quadratic q, double) {
                q.b = -q.b;
                return q;
            }>},
    HitSlip{&kSphereDistance,
            "The origin of the ray is left out: b and c are made of O - C, not of C alone.",
            withoutOrigin},
    HitSlip{&kSphereDistance, "The discriminant is b * b - 4 a c: the 4 is left out.",
            [](const SceneDescription& scene, int object, const Ray& ray) {
                Quadratic q = quadraticOf(scene, object, ray);
                const double inside = q.b * q.b - q.c;
                if (inside < 0.0) return Distance{};
                const double near = (-q.b - std::sqrt(inside)) / 2.0;
                return ifAhead(near > 0.0 ? near : (-q.b + std::sqrt(inside)) / 2.0);
            }},
    HitSlip{&kSphereDistance, "The roots are divided by 2 a, not by a: (-b - root) / (2 * a).",
            withoutDivision},
    HitSlip{&kSphereDistance,
            "That is the point of the ray that is nearest to the centre: the root of the "
            "discriminant is missing, (-b - std::sqrt(discriminant)) / (2 a).",
            chosen<[](const Quadratic& q) { return ifAhead(-q.b / 2.0); }>},
};

constexpr maintick::HitTexts kSphereTexts{
    &kSphereMissed,
    &kSpherePhantom,
    &kSphereBehind,
    &kSphereInside,
    &kSphereDistance,
    &kSphereLocation,
    &kSphereNormal,
    &kSphereObject,
    &kSphereTurned,
    &kSphereLength,
    "The normal of a sphere at a point of it is (location - centre()).normalised(): "
    "getNormalAt(location).",
    kSphereFindings};

/// How a ray starts: along its direction from the centre, and aside, in radii.
struct Start {
    Place place;
    double along;
    double asideLow;
    double asideHigh;
};

// Every origin is at least 0.2 radii from the surface, and no line nearer than 0.1 radii to a
// tangent.
constexpr std::array kStarts{
    Start{Place::outside, -3.5, 0.1, 0.85},     Start{Place::outside, -2.4, 0.1, 0.4},
    Start{Place::outside, -6.0, 0.5, 0.85},     Start{Place::behind, 2.6, 0.1, 0.8},
    Start{Place::past, -3.0, 1.15, 1.4},        Start{Place::past, -1.8, 1.3, 1.8},
    Start{Place::inside, -0.5, 0.1, 0.5},       Start{Place::inside, 0.5, 0.1, 0.5},
    Start{Place::longDirection, -3.0, 0.2, 0.7}};

AskedHit drawHit(Draw& draw, const SceneDescription& scene, int object, const Start& start) {
    const auto& sphere = scene.spheres[static_cast<std::size_t>(object)];
    const Vector3 direction = draw.direction();
    const Vector3 aside = perpendicularsOf(direction).first;
    AskedHit asked;
    asked.place = start.place;
    asked.ray.object = object;
    asked.ray.origin = sphere.centre + (direction * start.along +
                                        aside * draw.between(start.asideLow, start.asideHigh)) *
                                           sphere.radius;
    asked.ray.direction = direction * (start.place == Place::longDirection ? 2.5 : 1.0);
    asked.object = fmt::format("a sphere with centre {} and radius {:.4g}",
                               maintick::words(sphere.centre), sphere.radius);
    asked.expected = maintick::meet(sphere, asked.line());
    return asked;
}

}  // namespace

TaskJudgement judgeSpheres(probe::Examinee& examinee, std::uint64_t seed) {
    Draw draw{seed, 101};
    SceneDescription scene;
    std::vector<AskedHit> asked;
    for (const double radius : {2.0, 0.35, 1.3, 0.6, 2.4}) {
        const Vector3 centre{draw.between(-3.0, 3.0), draw.between(-3.0, 3.0),
                             draw.between(2.0, 6.0)};
        scene.spheres.push_back({centre, radius * draw.between(0.9, 1.1), {}, nullptr});
    }
    for (const Start& start : kStarts)
        for (int object = 0; object < static_cast<int>(scene.spheres.size()); ++object)
            asked.push_back(drawHit(draw, scene, object, start));
    return maintick::judgeHits(examinee, scene, asked, kSphereSlips, kSphereTexts,
                               "Sphere::intersectionWith");
}

}  // namespace ticker::tasks
