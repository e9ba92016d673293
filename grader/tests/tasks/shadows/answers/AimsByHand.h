#ifndef TICKER_TESTS_TASKS_SHADOWS_ANSWERS_AIMSBYHAND_H
#define TICKER_TESTS_TASKS_SHADOWS_ANSWERS_AIMSBYHAND_H

#include <grader/tasks/shadows/answers/ShadowAims.h>
#include <grader/tasks/support/Draw.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace ticker::tasks {

/// Aim points of a submission, in radii of the light.
using Aim = std::function<Vector3(Draw&)>;

inline Vector3 ball(Draw& draw) {
    return draw.direction() * std::cbrt(draw.between(0.0, 1.0));
}

inline Vector3 polarHelper(Draw& draw) {
    const double radius = draw.between(0.0, 1.0);
    const double theta = draw.between(0.0, std::numbers::pi);
    const double phi = draw.between(0.0, 2.0 * std::numbers::pi);
    return Vector3{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                   std::cos(theta)} *
           radius;
}

/// Aim points that depend on the direction from the point to the light.
using FacingAim = std::function<Vector3(Draw&, const Vector3&)>;

/// The verdict on aims at three far lights, which are seen along `axis` and two perpendicular
/// directions, with ten rays from 67 points each.
inline AimVerdict judgeFacing(const FacingAim& aim, const Vector3& axis, std::uint64_t seed) {
    Draw draw{seed, 1};
    const Perpendiculars sides = perpendicularsOf(axis);
    const double radius = 0.4;
    const double distance = 120.0;
    std::vector<ShadowQuestion> questions(3);
    std::vector<ShadowLog> logs(3);
    std::vector<const ShadowLog*> pointers;
    const Vector3 directions[3] = {axis, sides.first, sides.second};
    for (std::size_t i = 0; i < 3; ++i) {
        raytracer::SceneDescription& scene = questions[i].question.scene;
        const Vector3 light = directions[i] * distance;
        scene.pointLights.emplace_back(light, raytracer::ColourRGB{1.0}, 1.0);
        scene.planes.push_back({{}, directions[i], {}});
        logs[i].asked = &questions[i];
        for (int p = 0; p < 67; ++p) {
            PointLog point;
            point.lines.resize(1);
            for (int r = 0; r < 10; ++r) {
                AimLine line;
                line.direction = (light + aim(draw, directions[i]) * radius).normalised();
                line.foot = line.direction * light.dot(line.direction) - light;
                line.miss = line.foot.magnitude();
                point.lines[0].push_back(line);
            }
            logs[i].points.push_back(point);
        }
        pointers.push_back(&logs[i]);
    }
    return judgeAims(pointers);
}

inline AimVerdict judgeAlong(const Aim& aim, const Vector3& axis, std::uint64_t seed) {
    return judgeFacing([&](Draw& draw, const Vector3&) { return aim(draw); }, axis, seed);
}

/// A disc that faces the point; `radiusOf` maps a number between 0 and 1 to the distance from its
/// centre.
/// @param squeezed  Factor of one of the disc's two axes.
inline FacingAim facingDisc(const std::function<double(double)>& radiusOf, double squeezed = 1.0) {
    return [=](Draw& draw, const Vector3& axis) {
        const Perpendiculars sides = perpendicularsOf(axis);
        const double angle = draw.between(0.0, 2.0 * std::numbers::pi);
        const double radius = radiusOf(draw.between(0.0, 1.0));
        return (sides.first * std::cos(angle) + sides.second * (squeezed * std::sin(angle))) *
               radius;
    };
}

}  // namespace ticker::tasks

#endif
