#include <grader/tasks/maintick/Hits.h>
#include <grader/tasks/maintick/JudgeMainTick.h>
#include <grader/tasks/maintick/MainTickFindings.h>
#include <grader/tasks/support/Draw.h>

#include <fmt/core.h>

#include <array>

namespace ticker::tasks {
namespace {

using maintick::AskedHit;
using maintick::HitMistake;
using maintick::Place;
using raytracer::Ray;
using raytracer::SceneDescription;
using Distance = std::optional<double>;

/// s = height / slope.
struct Fraction {
    double height = 0.0;    ///< (Q - O).N
    double slope = 0.0;     ///< D.N
    double ofPoint = 0.0;   ///< Q.N
    double ofOrigin = 0.0;  ///< O.N
    double ofFirst = 0.0;   ///< Q.N of the first plane
};

template <auto Solve>
Distance solved(const SceneDescription& scene, int object, const Ray& ray) {
    const auto& plane = scene.planes[static_cast<std::size_t>(object)];
    const Vector3 normal = plane.normal.normalised();
    const auto& first = scene.planes[0];
    return Solve(Fraction{(plane.point - ray.origin).dot(normal), ray.direction.dot(normal),
                          plane.point.dot(normal), ray.origin.dot(normal),
                          first.point.dot(first.normal.normalised())});
}

Distance inFront(double distance) {
    return distance > 0.0 ? Distance{distance} : Distance{};
}

const std::array kPlaneMistakes{
    HitMistake{&kPlaneDistance,
               "The sign is wrong: s = (Q - O).N / D.N, from the origin of the ray to the plane.",
               solved<[](const Fraction& f) { return inFront(-f.height / f.slope); }>},
    HitMistake{&kPlaneDistance, "The origin of the ray is left out: s = (Q - O).N / D.N.",
               solved<[](const Fraction& f) { return inFront(f.ofPoint / f.slope); }>},
    HitMistake{
        &kPlaneDistance, "O is added instead of subtracted: s = (Q - O).N / D.N.",
        solved<[](const Fraction& f) { return inFront((f.ofPoint + f.ofOrigin) / f.slope); }>},
    HitMistake{&kPlaneDistance, "The point of the plane is left out: s = (Q - O).N / D.N.",
               solved<[](const Fraction& f) { return inFront(-f.ofOrigin / f.slope); }>},
    HitMistake{&kPlaneDistance, "The division by D.N is missing: s = (Q - O).N / D.N.",
               solved<[](const Fraction& f) { return inFront(f.height); }>},
    HitMistake{&kPlaneDistance, "The fraction is upside down: s = (Q - O).N / D.N.",
               solved<[](const Fraction& f) { return inFront(f.slope / f.height); }>},
    HitMistake{&kPlaneDistance, "It is multiplied where it should be divided: s = (Q - O).N / D.N.",
               solved<[](const Fraction& f) { return inFront(f.slope * f.height); }>},
    HitMistake{&kPlaneBehind, "",
               solved<[](const Fraction& f) { return Distance{f.height / f.slope}; }>},
    HitMistake{
        &kPlaneBehind,
        "The absolute value brings what lies behind the ray before it: leave it out, and return "
        "std::nullopt where s is negative.",
        solved<[](const Fraction& f) { return Distance{std::abs(f.height / f.slope)}; }>},
    HitMistake{&kPlaneBehind, "The test is the wrong way round: a positive s is a hit.",
               solved<[](const Fraction& f) {
                   return f.height / f.slope < 0.0 ? Distance{f.height / f.slope} : Distance{};
               }>},
    HitMistake{&kPlaneOneSided, "", solved<[](const Fraction& f) {
                   return f.slope < 0.0 ? inFront(f.height / f.slope) : Distance{};
               }>},
    HitMistake{&kPlaneOneSided, "", solved<[](const Fraction& f) {
                   return 0.0 < f.slope ? inFront(f.height / f.slope) : Distance{};
               }>},
    HitMistake{&kPlaneOneSided, "", solved<[](const Fraction& f) {
                   return f.slope < 0.0 ? Distance{f.height / f.slope} : Distance{};
               }>},
    HitMistake{&kPlaneOneSided,
               "The absolute value of D.N loses the side that the ray comes from: leave it out.",
               solved<[](const Fraction& f) { return inFront(f.height / std::abs(f.slope)); }>},
    HitMistake{&kPlaneDistance,
               "That is how far the origin is from the plane. The distance is s, along the ray: "
               "s = (Q - O).N / D.N.",
               solved<[](const Fraction& f) {
                   return 0.0 < f.height / f.slope ? Distance{std::abs(f.height)} : Distance{};
               }>},
    HitMistake{
        &kPlaneDistance,
        "The point of another plane is used here: a static or global variable keeps the first. "
        "Work everything out in each call.",
        solved<[](const Fraction& f) { return inFront((f.ofFirst - f.ofOrigin) / f.slope); }>},
    HitMistake{&kPlaneMissed,
               "A limit cuts far hits off: every positive s is a hit, however large it is.",
               solved<[](const Fraction& f) {
                   const double s = f.height / f.slope;
                   return 1000.0 < s ? Distance{} : inFront(s);
               }>},
    HitMistake{
        &kPlaneMissed,
        "A tolerance of D.N cuts floors off before the horizon: leave rays out only where D.N "
        "is 0, or below 1e-6.",
        solved<[](const Fraction& f) {
            return std::abs(f.slope) < 0.01 ? Distance{} : inFront(f.height / f.slope);
        }>},
    HitMistake{&kPlaneMissed,
               "A limit cuts near hits off: every positive s is a hit, however small it is.",
               solved<[](const Fraction& f) {
                   const double s = f.height / f.slope;
                   return s < 0.05 ? Distance{} : inFront(s);
               }>},
};

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

AskedHit hitFrom(Draw& draw, const SceneDescription& scene, int object, Place place,
                 const Vector3& direction, double distance) {
    const auto& plane = scene.planes[static_cast<std::size_t>(object)];
    const Vector3 normal = plane.normal.normalised();
    const Vector3 foot = plane.point + perpendicularsOf(normal).first * draw.between(-2.0, 2.0);
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

/// @param side  1: from the side that the normal points to; -1: from the other one.
AskedHit drawHit(Draw& draw, const SceneDescription& scene, int object, Place place, double side) {
    const Vector3 normal = scene.planes[static_cast<std::size_t>(object)].normal.normalised();
    // D.N is at least 0.4, so that the distance is as exact as its parts.
    const Vector3 direction = draw.directionAround(normal * -side, 1.1);
    return hitFrom(draw, scene, object, place, direction, draw.between(1.0, 5.0));
}

/// Where limits and tolerances show that the handout does not have: grazing, as near the horizon of
/// a floor, near, and far away.
void addExtremes(Draw& draw, SceneDescription& scene, std::vector<AskedHit>& asked) {
    constexpr double kGrazing = 0.008;  // of D.N: in float the distance is right to 1e-4
    constexpr double kNear = 0.03;
    constexpr double kFar = 2000.0;
    const Vector3 normal = scene.planes[0].normal.normalised();
    const Vector3 along = perpendicularsOf(normal).second;
    const Vector3 grazing = (along - normal * kGrazing).normalised();
    asked.push_back(hitFrom(draw, scene, 0, Place::outside, grazing, 6.0));
    const Vector3 down = draw.directionAround(normal * -1.0, 1.1);
    asked.push_back(hitFrom(draw, scene, 0, Place::outside, down, kNear));
    const int far = static_cast<int>(scene.planes.size());
    scene.planes.push_back({draw.direction() * kFar, normal, {}});
    asked.push_back(hitFrom(draw, scene, far, Place::outside, down, kFar));
}

}  // namespace

TaskJudgement judgePlanes(probe::Examinee& examinee, std::uint64_t seed) {
    Draw draw{seed, 102};
    SceneDescription scene;
    std::vector<AskedHit> asked;
    for (int i = 0; i < 5; ++i) {
        const Vector3 point{draw.between(-3.0, 3.0), draw.between(-3.0, 3.0),
                            draw.between(2.0, 6.0)};
        scene.planes.push_back({point, draw.direction() * draw.between(0.5, 3.0), {}});
    }
    for (const Place place : {Place::outside, Place::inside, Place::behind, Place::longDirection})
        for (int object = 0; object < 5; ++object) {
            const bool isFromBack = place == Place::inside || object % 2 == 1;
            const double side = place == Place::outside || !isFromBack ? 1.0 : -1.0;
            asked.push_back(drawHit(draw, scene, object, place, side));
        }
    addExtremes(draw, scene, asked);
    return maintick::judgeHits(examinee, scene, asked, kPlaneMistakes, kPlaneTexts,
                               "Plane::intersectionWith");
}

}  // namespace ticker::tasks
