#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Draw.h>

#include <cmath>
#include <numbers>

namespace ticker::tasks {
namespace {

constexpr int kPointsLowLight = 10;

// Angle between the direction to a viewer and the normal, radians.
constexpr double kLowest = 1.2;
constexpr double kHighest = 1.35;

}  // namespace

ShadowQuestion drawLowLight(Draw& draw) {
    const Vector3 foot = drawPlace(draw);
    const Vector3 eye = (-foot).normalised();
    // The eye sees the floor from as low a place as the viewers, and from the same side: no reading
    // has a highlight.
    const double lean = draw.between(kLowest, kHighest);
    const double turned = draw.between(0.0, 2.0 * std::numbers::pi);
    const Perpendiculars sides = perpendicularsOf(eye);
    const Vector3 side = sideAt(sides, turned);
    const Vector3 up = eye * std::cos(lean) + side * std::sin(lean);
    const Vector3 near = (eye - up * eye.dot(up)).normalised();
    const Vector3 across = up.cross(near);
    // The light is 65 to 70 degrees from the normal, so that all of it is above the horizon.
    const double fromNormal = draw.between(1.13, 1.22);
    const double distance = draw.between(5.0, 7.0);
    const Vector3 towards = up * std::cos(fromNormal) + near * std::sin(fromNormal);
    const Vector3 light = foot + towards * distance;

    ShadowQuestion drawn;
    drawn.purpose = ShadowQuestion::Purpose::lowLight;
    raytracer::SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    scene.pointLights.push_back(drawLight(draw, light, distance));
    raytracer::Material floor = drawMaterial(draw);
    // Even and odd exponents, so low that the highlight of a negative R.V is as bright as the
    // diffuse light.
    floor.phongAlpha = draw.whole(2, 5);
    scene.planes.push_back({foot, up, floor});
    for (int i = 0; i < kPointsLowLight; ++i) {
        const double x = draw.between(-0.3, 0.3);
        const Vector3 point = foot + near * x + across * draw.between(-0.3, 0.3);
        const double low = draw.between(kLowest, kHighest);
        const double turn = draw.between(-0.3, 0.3);
        const Vector3 flat = near * std::cos(turn) + across * std::sin(turn);
        const Vector3 viewer = up * std::cos(low) + flat * std::sin(low);
        drawn.question.points.push_back({0, point, up, point + viewer * draw.between(3.0, 5.0)});
        drawn.zones.push_back({Zone::lit});
    }
    setCapacity(drawn);
    return drawn;
}

}  // namespace ticker::tasks
