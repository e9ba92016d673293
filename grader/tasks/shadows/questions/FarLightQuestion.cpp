#include <grader/tasks/shadows/questions/ShadowDraws.h>

#include <cmath>
#include <numbers>

namespace ticker::tasks {
namespace {

// 67 points in each of three questions give 2010 aim lines.
constexpr int kPointsFar = 67;

/// A unit vector whose angle to `axis` is from `least` to `most`, radians.
Vector3 drawAside(Draw& draw, const Vector3& axis, double least, double most) {
    const Perpendiculars sides = perpendicularsOf(axis);
    const double away = draw.between(least, most);
    const double around = draw.between(0.0, 2.0 * std::numbers::pi);
    return axis * std::cos(away) + sideAt(sides, around) * std::sin(away);
}

// A viewer far aside from the light and about as far away. From the point it is in another
// direction than the light, and from the light in another direction than the point, so that a disc
// that faces the viewer looks narrow.
Vector3 drawFarViewer(Draw& draw, const Vector3& point, const Vector3& normal,
                      const Vector3& light) {
    const Vector3 way = light - point;
    Vector3 towards = drawAside(draw, way.normalised(), 0.8, 1.5);
    while (towards.dot(normal) < 0.1)
        towards = drawAside(draw, way.normalised(), 0.8, 1.5);
    return point + towards * (way.magnitude() * draw.between(1.1, 2.0));
}

}  // namespace

ShadowQuestion drawFarLight(Draw& draw, const Vector3& towards) {
    // The normal leans away from the light, so that a disc that faces along the normal looks
    // narrow.
    const Vector3 up = drawAside(draw, towards, 0.65, 0.9);
    const Perpendiculars sides = perpendicularsOf(up);
    const Vector3 foot = drawPlace(draw);
    const double distance = draw.between(100.0, 140.0);

    ShadowQuestion drawn;
    drawn.purpose = ShadowQuestion::Purpose::farLight;
    raytracer::SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    scene.pointLights.push_back(drawLight(draw, foot + towards * distance, distance));
    scene.planes.push_back({foot, up, drawMaterial(draw)});
    for (int i = 0; i < kPointsFar; ++i) {
        // Close together, so that a repeated aim point is recognised; not equal, in case the code
        // seeds a generator from the point.
        const double x = draw.between(-1e-4, 1e-4);
        const Vector3 point = foot + sides.first * x + sides.second * draw.between(-1e-4, 1e-4);
        const Vector3 light = scene.pointLights[0].position();
        const Vector3 viewer = draw.whole(0, 3) == 0 ? drawViewer(draw, point, up, light)
                                                     : drawFarViewer(draw, point, up, light);
        drawn.question.points.push_back({0, point, up, viewer});
        drawn.zones.push_back({Zone::lit});
    }
    setCapacity(drawn);
    return drawn;
}

}  // namespace ticker::tasks
