#ifndef TICKER_TASKS_MAINTICK_HITS_H
#define TICKER_TASKS_MAINTICK_HITS_H

#include <grader/probe/Examinee.h>
#include <grader/result/SubmissionResult.h>
#include <grader/tasks/maintick/Exact.h>

#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace ticker::tasks::maintick {

/// Where a ray starts, seen from the object that it is asked of.
enum class Place { outside, behind, past, inside, longDirection };

/// One ray, and what an object should say of it.
struct AskedHit {
    Place place = Place::outside;
    probe::CastRay ray;
    std::string object;  ///< in words: "a sphere with centre (1, 2, 3) and radius 2"
    std::optional<Meeting> expected;
    double tolerance = kTolerance;  ///< of the distance

    [[nodiscard]] Ray line() const { return {ray.origin, ray.direction}; }
};

/// Distance of a hit; empty for a miss.
using Distance = std::optional<double>;
/// Hint for code that drops hits with a z below 0.
inline constexpr const char* kBehindCameraHint =
    "What lies behind the camera is hit as well, since shadow rays and mirrored rays go there: "
    "compare s alone, and no z.";
[[nodiscard]] inline Distance ifAhead(double distance) {
    return distance > 0.0 ? Distance{distance} : Distance{};
}
/// The same distance, but empty if the hit's z is below 0.
[[nodiscard]] inline Distance ifBeforeCamera(const Ray& ray, const Distance& distance) {
    return distance && ray.evaluateAt(*distance).z >= 0.0 ? distance : Distance{};
}

/// Hint for code that treats a ray along an axis, or a level one, as parallel to what it meets.
inline constexpr const char* kStillHint =
    "A ray whose direction has a 0 among its coordinates, as one that is level or goes straight "
    "ahead, meets things like every other ray: leave tests of single coordinates out.";
/// The same distance, but empty if the ray's direction is nearly 0 in all of these coordinates.
/// @param coordinates  Sum of 1 for x, 2 for y and 4 for z.
[[nodiscard]] inline Distance unlessStill(unsigned coordinates, const Ray& ray,
                                          const Distance& distance) {
    constexpr double kStill = 1e-3;
    const Vector3& D = ray.direction;
    const unsigned still = (std::abs(D.x) < kStill ? 1U : 0U) | (std::abs(D.y) < kStill ? 2U : 0U) |
                           (std::abs(D.z) < kStill ? 4U : 0U);
    return (still & coordinates) == coordinates ? Distance{} : distance;
}

/// A known mistake in the distance: its name, what it answers, and what mends it.
struct HitMistake {
    const FindingText* finding;
    Distance (*distance)(const raytracer::SceneDescription& scene, int object, const Ray& ray);
    const char* hint = "";     ///< empty: that of `finding`
    bool isSometimes = false;  ///< the right distance may be answered as well
};

/// The known mistakes of M1 and of M3.1.
[[nodiscard]] std::span<const HitMistake> sphereMistakes();
[[nodiscard]] std::span<const HitMistake> planeMistakes();

/// Findings for answers that no known mistake explains, and for wrong fields of a hit.
struct HitTexts {
    const FindingText* missed;
    const FindingText* phantom;  ///< a hit where the ray passes by
    const FindingText* behind;
    const FindingText* inside;  ///< of rays that start inside, or on the other side
    const FindingText* distance;
    const FindingText* location;
    const FindingText* normal;
    const FindingText* object;
    const FindingText* turned;  ///< a note: normals that are turned towards the ray
    const FindingText* length;  ///< of directions that are no unit vectors; null: not asked
    const char* normalHint;     ///< for a wrong normal, unless only its sign or length is wrong
    std::span<const FindingText* const> order;
};

/// Asks all rays of one scene and judges the answers.
/// @param function  "Sphere::intersectionWith"
[[nodiscard]] TaskJudgement judgeHits(probe::Examinee& examinee,
                                      const raytracer::SceneDescription& scene,
                                      const std::vector<AskedHit>& asked,
                                      std::span<const HitMistake> mistakes, const HitTexts& texts,
                                      const std::string& function);

}  // namespace ticker::tasks::maintick

#endif
