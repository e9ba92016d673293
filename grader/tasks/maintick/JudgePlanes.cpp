#include <grader/tasks/maintick/Hits.h>
#include <grader/tasks/maintick/JudgeMainTick.h>
#include <grader/tasks/maintick/MainTickFindings.h>
#include <grader/tasks/support/Draw.h>

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace ticker::tasks {
namespace {

using maintick::AskedHit;
using maintick::Place;
using raytracer::SceneDescription;

constexpr maintick::HitTexts kPlaneTexts{&kPlaneMissed,
                                         &kPlaneDistance,
                                         &kPlaneBehind,
                                         &kPlaneOneSided,
                                         &kPlaneDistance,
                                         &kPlaneLocation,
                                         &kPlaneNormal,
                                         &kPlaneObject,
                                         &kPlaneTurned,
                                         &kPlaneLength,
                                         "A plane has the same normal everywhere: normal().",
                                         kPlaneFindings};

constexpr double kLowTolerance = 2e-3;  ///< of a hit about 0.06 away

/// @param foot  A point of the plane, that the ray's line meets.
AskedHit hitAt(const Vector3& foot, const SceneDescription& scene, int object, Place place,
               const Vector3& direction, double distance) {
    const auto& plane = scene.planes[static_cast<std::size_t>(object)];
    const Vector3 normal = plane.normal.normalised();
    AskedHit asked;
    asked.place = place;
    asked.ray.object = object;
    asked.ray.origin = foot - direction * (place == Place::behind ? -distance : distance);
    asked.ray.direction = direction * (place == Place::longDirection ? 2.5 : 1.0);
    asked.object = fmt::format("a plane through {} with normal {}", maintick::words(plane.point),
                               maintick::words(normal));
    asked.expected = maintick::meet(plane, asked.line());
    return asked;
}

AskedHit hitFrom(Draw& draw, const SceneDescription& scene, int object, Place place,
                 const Vector3& direction, double distance) {
    const auto& plane = scene.planes[static_cast<std::size_t>(object)];
    const Vector3 along = perpendicularsOf(plane.normal.normalised()).first;
    return hitAt(plane.point + along * draw.between(-2.0, 2.0), scene, object, place, direction,
                 distance);
}

/// @param side  1: from the side that the normal points to; -1: from the other one.
AskedHit drawHit(Draw& draw, const SceneDescription& scene, int object, Place place, double side) {
    const Vector3 normal = scene.planes[static_cast<std::size_t>(object)].normal.normalised();
    // D.N is at least 0.4, so that the distance is as exact as its parts.
    const Vector3 direction = draw.directionAround(normal * -side, 1.1);
    return hitFrom(draw, scene, object, place, direction, draw.between(1.0, 5.0));
}

/// Adds rays that show limits and tolerances which the handout does not have: one grazes the plane,
/// as near the horizon of a floor, one starts close to it, and one far away.
void addExtremes(Draw& draw, SceneDescription& scene, std::vector<AskedHit>& asked) {
    // This D.N is that of a ray less than two rows below the horizon, in a picture that is 640
    // wide. From so far away the distance is right to 1e-4 in single precision.
    constexpr double kGrazing = 0.0025;
    constexpr double kGrazingDistance = 60.0;
    constexpr double kNear = 0.0025;  // right to 1e-5 in single precision
    constexpr double kNearTolerance = 5e-5;
    constexpr double kFar = 2000.0;
    const Vector3 normal = scene.planes[0].normal.normalised();
    const Vector3 along = perpendicularsOf(normal).second;
    const Vector3 grazing = (along - normal * kGrazing).normalised();
    asked.push_back(hitFrom(draw, scene, 0, Place::outside, grazing, kGrazingDistance));
    const Vector3 down = draw.directionAround(normal * -1.0, 1.1);
    asked.push_back(hitFrom(draw, scene, 0, Place::outside, down, kNear));
    asked.back().tolerance = kNearTolerance;
    const int far = static_cast<int>(scene.planes.size());
    scene.planes.push_back({draw.direction() * kFar, normal, {}});
    asked.push_back(hitFrom(draw, scene, far, Place::outside, down, kFar));
}

/// Adds rays that start less than a thousandth above a plane and run nearly along it. Their hits
/// are far enough away that no usual lower limit on the distance drops them. In single precision
/// the height is right to 2e-6, the distance to 2e-4.
void addLow(Draw& draw, const SceneDescription& scene, std::vector<AskedHit>& asked) {
    constexpr double kSlope = 0.012;
    for (std::size_t object = 0; object < 5; ++object) {
        const Vector3 normal = scene.planes[object].normal.normalised();
        const Perpendiculars sides = perpendicularsOf(normal);
        const double turn = draw.between(0.0, 2.0 * std::numbers::pi);
        const Vector3 along = sides.first * std::cos(turn) + sides.second * std::sin(turn);
        const double side = object % 2 == 0 ? 1.0 : -1.0;
        const Vector3 low = (along - normal * (side * kSlope)).normalised();
        asked.push_back(hitFrom(draw, scene, static_cast<int>(object),
                                side > 0.0 ? Place::outside : Place::inside, low,
                                draw.between(0.056, 0.07)));
        asked.back().tolerance = kLowTolerance;
    }
}

/// Adds two more planes through one point, asked from one origin. Each ray has a direction of its
/// own, within 0.3 radians of the one to that point.
void addCorner(Draw& draw, SceneDescription& scene, std::vector<AskedHit>& asked) {
    const Vector3 corner{draw.between(-2.0, 2.0), draw.between(-2.0, 2.0), draw.between(3.0, 5.0)};
    const Vector3 origin = corner + draw.direction() * draw.between(2.0, 3.0);
    const Vector3 direction = (corner - origin).normalised();
    const Perpendiculars sides = perpendicularsOf(direction);
    for (const auto& [lean, weight] : {std::pair{sides.first, 1.0}, {sides.second, 0.4}}) {
        const int object = static_cast<int>(scene.planes.size());
        scene.planes.push_back({corner, (lean * weight - direction).normalised(), {}});
        AskedHit one =
            hitAt(corner, scene, object, Place::outside, draw.directionAround(direction, 0.3), 1.0);
        one.ray.origin = origin;
        one.expected = maintick::meet(scene.planes.back(), one.line());
        asked.push_back(one);
    }
}

/// Adds hits far from the point that defines the plane, both ways along both tangents. The last one
/// on each side is hit from close by.
void addAside(Draw& draw, const SceneDescription& scene, std::vector<AskedHit>& asked) {
    constexpr double kFarthest = 400.0;
    const auto& plane = scene.planes[0];
    const Vector3 normal = plane.normal.normalised();
    const Perpendiculars sides = perpendicularsOf(normal);
    for (const Vector3& side : {sides.first, -sides.first, sides.second, -sides.second}) {
        for (const double aside : {draw.between(7.0, 12.0), draw.between(0.8, 1.0) * kFarthest}) {
            const Vector3 down = draw.directionAround(-normal, 1.1);
            asked.push_back(hitAt(plane.point + side * aside, scene, 0, Place::outside, down,
                                  draw.between(2.0, 5.0)));
        }
        // Right to 1e-4 in single precision.
        const Vector3 down = draw.directionAround(-normal, 0.5);
        asked.push_back(hitAt(plane.point + side * kFarthest, scene, 0, Place::outside, down,
                              draw.between(0.02, 0.03)));
    }
}

/// Adds planes whose normals lean by two degrees, or by half a degree, from either end of each
/// axis. Code for level floors or upright walls treats them as if they did not lean. The rays hit
/// them along the slope from the plane's point, where such code is wrong by 0.009 or more.
void addLeaning(Draw& draw, SceneDescription& scene, std::vector<AskedHit>& asked) {
    for (const Vector3& axis :
         {Vector3{1.0, 0.0, 0.0}, Vector3{0.0, 1.0, 0.0}, Vector3{0.0, 0.0, 1.0}})
        for (const auto& [end, leaning] :
             {std::pair{axis, 1.0}, {-axis, 1.0}, {axis, 0.2}, {-axis, 0.2}}) {
            const double lean = leaning * draw.between(0.03, 0.04);
            const Vector3 side = end.cross(draw.direction()).normalised();
            const Vector3 normal = end * std::cos(lean) + side * std::sin(lean);
            const Vector3 slope = end * std::sin(lean) - side * std::cos(lean);
            const Vector3 point{draw.between(-3.0, 3.0), draw.between(-3.0, 3.0),
                                draw.between(2.0, 6.0)};
            const int object = static_cast<int>(scene.planes.size());
            scene.planes.push_back({point, normal, {}});
            const Vector3 foot = point + slope * draw.between(1.5, 2.5);
            const Vector3 down = draw.directionAround(-normal, 1.1);
            asked.push_back(
                hitAt(foot, scene, object, Place::outside, down, draw.between(1.0, 5.0)));
        }
}

/// Adds planes at right angles to the axes. One ray meets each head-on, and one has a 0 in another
/// coordinate of its direction: code may divide by that 0, or treat the ray as parallel.
void addLevel(Draw& draw, SceneDescription& scene, std::vector<AskedHit>& asked) {
    constexpr std::array kAxes{&Vector3::x, &Vector3::y, &Vector3::z};
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
        for (const std::size_t turn : {1U, 2U}) {
            Vector3 normal;
            normal.*kAxes.at(axis) = turn == 1U ? 1.0 : -1.0;
            const int object = static_cast<int>(scene.planes.size());
            scene.planes.push_back(
                {{draw.between(-3.0, 3.0), draw.between(-3.0, 3.0), draw.between(2.0, 6.0)},
                 normal,
                 {}});
            Vector3 level = draw.directionAround(-normal, 1.1);
            level.*kAxes.at((axis + turn) % kAxes.size()) = 0.0;
            for (const Vector3& direction : {-normal, level.normalised()})
                asked.push_back(hitFrom(draw, scene, object, Place::outside, direction,
                                        draw.between(1.0, 5.0)));
        }
}

}  // namespace

TaskJudgement judgePlanes(probe::Examinee& examinee, std::uint64_t seed) {
    Draw draw{seed, 102};
    SceneDescription scene;
    std::vector<AskedHit> asked;
    for (int i = 0; i < 5; ++i) {
        // The last two lie behind the camera, where mirrored rays and shadow rays meet them.
        const double side = i < 3 ? 1.0 : -1.0;
        const Vector3 point{draw.between(-3.0, 3.0), draw.between(-3.0, 3.0),
                            side * draw.between(2.0, 6.0)};
        const Vector3 N = draw.direction();
        scene.planes.push_back({point, N * draw.between(0.5, 3.0), {}});
    }
    for (const Place place : {Place::outside, Place::inside, Place::behind, Place::longDirection})
        for (int object = 0; object < 5; ++object) {
            const bool isFromBack = place == Place::inside || object % 2 == 1;
            const double side = place == Place::outside || !isFromBack ? 1.0 : -1.0;
            asked.push_back(drawHit(draw, scene, object, place, side));
        }
    addExtremes(draw, scene, asked);
    addLeaning(draw, scene, asked);
    addAside(draw, scene, asked);
    addLow(draw, scene, asked);
    addCorner(draw, scene, asked);
    addLevel(draw, scene, asked);
    return maintick::judgeHits(examinee, scene, asked, maintick::planeMistakes(), kPlaneTexts,
                               "Plane::intersectionWith");
}

}  // namespace ticker::tasks
