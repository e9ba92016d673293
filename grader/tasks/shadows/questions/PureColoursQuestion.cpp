#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Draw.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace ticker::tasks {
namespace {

using raytracer::SceneDescription;

constexpr int kPointsPureLights = 9;
constexpr int kPointsOnPureBall = 3;

// Bright, so that a light counts even by a luminance in which its channel weighs the least.
std::array<ColourRGB, 3> drawPureColours(Draw& draw) {
    std::array<ColourRGB, 3> colours;
    constexpr std::array kChannels{&ColourRGB::r, &ColourRGB::g, &ColourRGB::b};
    const int first = draw.whole(0, 2);
    for (std::size_t i = 0; i < colours.size(); ++i)
        colours[i].*kChannels[(i + static_cast<std::size_t>(first)) % kChannels.size()] =
            draw.between(0.7, 0.9);
    return colours;
}

// So little ambient light that no tolerance hides a light that is lost.
ColourRGB drawDim(Draw& draw) {
    return draw.colour(0.1, 0.2);
}

}  // namespace

ShadowQuestion drawPureLights(Draw& draw) {
    const Vector3 up = draw.direction();
    const Perpendiculars sides = perpendicularsOf(up);
    const Vector3 foot = drawPlace(draw);

    ShadowQuestion drawn;
    drawn.purpose = ShadowQuestion::Purpose::pureColours;
    SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = drawDim(draw);
    const double turn = draw.between(0.0, 2.0 * std::numbers::pi);
    double angle = turn;
    for (const ColourRGB& colour : drawPureColours(draw)) {
        const Vector3 around = sideAt(sides, angle);
        const Vector3 towards = (up + around * draw.between(1.3, 1.7)).normalised();
        const double distance = draw.between(5.0, 9.0);
        const Vector3 place = foot + towards * distance;
        scene.pointLights.emplace_back(place, colour, drawLight(draw, place, distance).intensity());
        angle += 2.0 * std::numbers::pi / 3.0;
    }
    raytracer::Material floor = drawMaterial(draw);
    floor.colour = draw.colour(0.5, 0.9);
    scene.planes.push_back({foot, up, floor});
    for (std::size_t i = 0; i < kPointsPureLights; ++i) {
        const double x = draw.between(-0.5, 0.5);
        const Vector3 point = foot + sides.first * x + sides.second * draw.between(-0.5, 0.5);
        const Vector3 light = scene.pointLights[i % scene.pointLights.size()].position();
        drawn.question.points.push_back({0, point, up, drawViewer(draw, point, up, light)});
        drawn.zones.push_back({Zone::lit, Zone::lit, Zone::lit});
    }
    setCapacity(drawn);
    return drawn;
}

ShadowQuestion drawPureSurfaces(Draw& draw) {
    const Vector3 middle = drawPlace(draw);
    const Vector3 row = draw.direction();
    const Vector3 towards = draw.directionAround(perpendicularsOf(row).first, 0.4);
    const double distance = draw.between(6.0, 9.0);
    const Vector3 light = middle + towards * distance;

    ShadowQuestion drawn;
    drawn.purpose = ShadowQuestion::Purpose::pureColours;
    SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = drawDim(draw);
    scene.pointLights.push_back(drawLight(draw, light, distance));
    // More than two radii apart, none before another.
    double along = -1.5;
    for (const ColourRGB& colour : drawPureColours(draw)) {
        raytracer::Material material = drawMaterial(draw);
        material.colour = colour;
        scene.spheres.push_back({middle + row * along, draw.between(0.3, 0.4), material, nullptr});
        along += 1.5;
    }
    for (int object = 0; object < 3; ++object)
        for (int i = 0; i < kPointsOnPureBall; ++i) {
            const auto& ball = scene.spheres[static_cast<std::size_t>(object)];
            const Vector3 normal = draw.directionAround((light - ball.centre).normalised(), 0.8);
            const Vector3 point = ball.centre + normal * ball.radius;
            drawn.question.points.push_back(
                {object, point, normal, drawViewer(draw, point, normal, light)});
            drawn.zones.push_back({Zone::lit});
        }
    setCapacity(drawn);
    return drawn;
}

}  // namespace ticker::tasks
