#include <grader/tasks/maintick/Hits.h>
#include <grader/tasks/maintick/JudgeMainTick.h>
#include <grader/tasks/maintick/MainTickFindings.h>
#include <grader/tasks/support/Draw.h>

#include <fmt/core.h>

#include <array>
#include <cstddef>
#include <string>

namespace ticker::tasks {
namespace {

using maintick::AskedHit;
using maintick::Place;
using raytracer::SceneDescription;

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

/// A sphere that gets a single ray, to show limits and tolerances that the handout does not have.
struct Alone {
    double radius;
    double farAway;  ///< of the centre from the origin of the world
    Start start;
};
// Where the rays start, sphere by sphere, in world units:
//   first and second: outside, 1.2 and 2000 from the centre
//   third: outside, 0.002 before the surface
//   fourth: inside, the near side 0.015 to 0.02 behind the ray
//   fifth: the sphere is behind the ray, its far side by 0.02 to 0.025
//   sixth: inside, the far side 0.002 ahead
//   seventh: the ray misses by as little as 0.006
//   eighth: a small sphere, with a discriminant of 0.0005 to 0.0006
//   then four large ones, for limits that grow with the radius: the surface 0.04 ahead of an
//     outside origin; a side 0.04 behind, then ahead of an inside origin; the sphere 0.04 behind
//   then one seen from 110 radii away: its discriminant is small beside b^2
//   last: so near that the half-angle of its cone is 56 degrees; the arc tangent of radius over
//     distance would be 40, and the ray is 48 degrees aside
// In single precision, distances, locations and normals are right to 2e-4; the roots of the large
// spheres are right to 1e-4, as their b is 400.
constexpr std::array kAlone{Alone{0.03, 5.0, {Place::outside, -40.0, 0.0, 0.5}},
                            Alone{200.0, 2000.0, {Place::outside, -10.0, 0.1, 0.8}},
                            Alone{0.3, 5.0, {Place::outside, -1.007, 0.0, 0.02}},
                            Alone{1.0, 5.0, {Place::inside, -0.98, 0.0, 0.09}},
                            Alone{1.0, 5.0, {Place::behind, 1.02, 0.0, 0.09}},
                            Alone{0.3, 5.0, {Place::inside, 0.993, 0.0, 0.02}},
                            Alone{0.03, 5.0, {Place::past, -40.0, 1.2, 1.3}},
                            Alone{0.012, 5.0, {Place::outside, -15.0, 0.0, 0.3}},
                            Alone{200.0, 5.0, {Place::outside, -1.0002, 0.0, 0.003}},
                            Alone{200.0, 5.0, {Place::inside, -0.9998, 0.0, 0.003}},
                            Alone{200.0, 5.0, {Place::inside, 0.9998, 0.0, 0.003}},
                            Alone{200.0, 5.0, {Place::behind, 1.0002, 0.0, 0.003}},
                            Alone{0.3, 5.0, {Place::outside, -110.0, 0.0, 0.05}},
                            Alone{1.0, 5.0, {Place::outside, -0.8, 0.88, 0.9}}};

std::string objectWords(const raytracer::SphereDescription& sphere) {
    return fmt::format("a sphere with centre {} and radius {:.4g}", maintick::words(sphere.centre),
                       sphere.radius);
}

/// A ray along an axis from inside, at a right angle to the line from the centre to its origin, so
/// that b of the quadratic is exactly 0.
AskedHit levelHit(Draw& draw, const SceneDescription& scene, int object) {
    const auto& sphere = scene.spheres[static_cast<std::size_t>(object)];
    const std::array axes{Vector3{1.0, 0.0, 0.0}, Vector3{0.0, 1.0, 0.0}, Vector3{0.0, 0.0, 1.0}};
    const auto first = static_cast<std::size_t>(draw.whole(0, 2));
    AskedHit asked;
    asked.place = Place::inside;
    asked.ray.object = object;
    asked.ray.origin = sphere.centre + axes.at(first) * (draw.between(0.2, 0.5) * sphere.radius);
    asked.ray.direction = axes.at((first + 1) % axes.size());
    asked.object = objectWords(sphere);
    asked.expected = maintick::meet(sphere, asked.line());
    return asked;
}

AskedHit hitAlong(Draw& draw, const SceneDescription& scene, int object, const Start& start,
                  const Vector3& direction) {
    const auto& sphere = scene.spheres[static_cast<std::size_t>(object)];
    const Vector3 aside = perpendicularsOf(direction).first;
    AskedHit asked;
    asked.place = start.place;
    asked.ray.object = object;
    asked.ray.origin = sphere.centre + (direction * start.along +
                                        aside * draw.between(start.asideLow, start.asideHigh)) *
                                           sphere.radius;
    asked.ray.direction = direction * (start.place == Place::longDirection ? 2.5 : 1.0);
    asked.object = objectWords(sphere);
    asked.expected = maintick::meet(sphere, asked.line());
    return asked;
}

AskedHit drawHit(Draw& draw, const SceneDescription& scene, int object, const Start& start) {
    return hitAlong(draw, scene, object, start, draw.direction());
}

/// Adds rays along each axis, and rays whose direction has a 0 in one coordinate.
void addStraight(Draw& draw, const SceneDescription& scene, std::vector<AskedHit>& asked) {
    constexpr std::array kAxes{&Vector3::x, &Vector3::y, &Vector3::z};
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
        Vector3 along;
        along.*kAxes.at(axis) = draw.whole(0, 1) == 0 ? 1.0 : -1.0;
        Vector3 level = draw.direction();
        level.*kAxes.at(axis) = 0.0;
        const int object = static_cast<int>(axis);
        for (const Vector3& direction : {along, level.normalised()})
            asked.push_back(hitAlong(draw, scene, object, kStarts.front(), direction));
    }
}

/// The same ray for a sphere and for a larger one around it: a result kept from one is wrong for
/// the other.
std::array<AskedHit, 2> drawConcentric(Draw& draw, SceneDescription& scene, int object) {
    constexpr double kLarger = 1.6;
    const AskedHit inner = drawHit(draw, scene, object, kStarts.front());
    auto larger = scene.spheres[static_cast<std::size_t>(object)];
    larger.radius *= kLarger;
    AskedHit outer = inner;
    outer.ray.object = static_cast<int>(scene.spheres.size());
    outer.object = objectWords(larger);
    outer.expected = maintick::meet(larger, outer.line());
    scene.spheres.push_back(larger);
    return {inner, outer};
}

}  // namespace

TaskJudgement judgeSpheres(probe::Examinee& examinee, std::uint64_t seed) {
    Draw draw{seed, 101};
    SceneDescription scene;
    std::vector<AskedHit> asked;
    for (const double radius : {2.0, 0.35, 1.3, 0.6, 2.4}) {
        // The last two lie behind the camera, where mirrored rays and shadow rays meet them.
        const double side = scene.spheres.size() < 3 ? 1.0 : -1.0;
        const Vector3 centre{draw.between(-3.0, 3.0), draw.between(-3.0, 3.0),
                             side * draw.between(2.0, 6.0)};
        scene.spheres.push_back({centre, radius * draw.between(0.9, 1.1), {}, nullptr});
    }
    for (const Start& start : kStarts)
        for (int object = 0; object < static_cast<int>(scene.spheres.size()); ++object)
            asked.push_back(drawHit(draw, scene, object, start));
    for (int object = 0; object < 2; ++object)
        asked.push_back(levelHit(draw, scene, object));
    for (const Alone& alone : kAlone) {
        scene.spheres.push_back({draw.direction() * alone.farAway, alone.radius, {}, nullptr});
        const int object = static_cast<int>(scene.spheres.size()) - 1;
        asked.push_back(drawHit(draw, scene, object, alone.start));
    }
    for (int object = 0; object < 2; ++object)
        for (const AskedHit& hit : drawConcentric(draw, scene, object))
            asked.push_back(hit);
    addStraight(draw, scene, asked);
    return maintick::judgeHits(examinee, scene, asked, maintick::sphereMistakes(), kSphereTexts,
                               "Sphere::intersectionWith");
}

}  // namespace ticker::tasks
