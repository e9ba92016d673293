#include <grader/tasks/maintick/mirrors/MirrorQuestions.h>

#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/Surfaces.h>

#include <array>

namespace ticker::tasks::maintick {
namespace {

using raytracer::Material;
using raytracer::SceneDescription;

constexpr int kMostBounces = 3;
constexpr int kDull = 2;
constexpr int kNearlyAll = 1;
constexpr int kWeak = 6;
constexpr double kBright = 25000.0;  ///< intensity of a light that makes colours above 10

Material materialWith(Draw& draw, double reflectivity) {
    Material material;
    material.colour = draw.colour(0.2, 0.9);
    material.reflectivity = reflectivity;
    return material;
}

/// Five mirroring balls and a dull one in a ring above a mirroring floor; open on all sides. A weak
/// mirror hangs below the floor, where no chain comes from above.
SceneDescription openScene(Draw& draw) {
    SceneDescription scene;
    scene.ambientLighting = draw.colour(0.03, 0.06);  // so that the background counts
    for (int i = 0; i < 6; ++i) {
        const double angle = 1.05 * i + draw.between(-0.15, 0.15);
        const Vector3 centre{2.2 * std::cos(angle), draw.between(-0.5, 0.5),
                             5.0 + 2.2 * std::sin(angle)};
        const double share = i == kDull        ? 0.0
                             : i == kNearlyAll ? draw.between(0.93, 0.97)
                                               : draw.between(0.2, 0.8);
        scene.spheres.push_back(
            {centre, draw.between(0.65, 0.9), materialWith(draw, share), nullptr});
    }
    scene.planes.push_back({{0.0, -1.6, 0.0},
                            {draw.between(-0.1, 0.1), 1.0, draw.between(-0.1, 0.1)},
                            materialWith(draw, 0.35)});
    scene.spheres.push_back({{0.0, -6.0, 5.0}, 0.7, materialWith(draw, 0.03), nullptr});
    return scene;
}

/// Whether neither the bias nor a small turn changes what the ray meets.
bool isClear(const SceneDescription& scene, const Ray& ray) {
    constexpr int kLongest = kMostBounces + 2;
    constexpr double kTurn = 0.01;
    const std::vector<int> chain = chainOf(scene, ray, kLongest, {});
    for (const MirrorStart& start : {MirrorStart{1e-6, false}, MirrorStart{1e-3, false},
                                     MirrorStart{1e-6, true}, MirrorStart{1e-3, true}})
        if (chainOf(scene, ray, kLongest, start) != chain) return false;
    const Perpendiculars sides = perpendicularsOf(ray.direction);
    for (const Vector3& turn : {sides.first, -sides.first, sides.second, -sides.second})
        if (chainOf(scene, {ray.origin, (ray.direction + turn * kTurn).normalised()}, kLongest,
                    {}) != chain)
            return false;
    return true;
}

/// Asks for the colour of each object, at one of its points and with the normal there.
void askEachObject(MirrorQuestion& asked) {
    const SceneDescription& scene = asked.question.scene;
    asked.direct.scene = scene;
    int object = 0;
    const Vector3 up{0.0, 1.0, 0.0};
    for (const auto& sphere : scene.spheres)
        asked.direct.points.push_back(
            {object++, sphere.centre + up * sphere.radius, up, sphere.centre + up * 5.0});
    for (const auto& plane : scene.planes) {
        const Vector3 normal = plane.normal.normalised();
        asked.direct.points.push_back({object++, plane.point, normal, plane.point + normal * 3.0});
    }
}

void addRays(MirrorQuestion& asked, const Ray& ray) {
    for (int bounces = 0; bounces <= kMostBounces; ++bounces)
        asked.question.rays.push_back({0, bounces, ray.origin, ray.direction});
}

/// Clear rays whose chains have at least `shortest` objects.
void addClearRays(Draw& draw, MirrorQuestion& asked, std::size_t shortest, int count) {
    constexpr int kMostTries = 4000;
    for (int tries = 0; count > 0 && tries < kMostTries; ++tries) {
        const Vector3 start{draw.between(-1.0, 1.0), draw.between(-0.3, 1.5),
                            draw.between(-1.0, 0.5)};
        const Vector3 target{draw.between(-2.5, 2.5), draw.between(-1.5, 0.8),
                             draw.between(3.0, 7.0)};
        const Ray ray{start, (target - start).normalised()};
        const auto chain = chainOf(asked.question.scene, ray, kMostBounces + 2, {});
        if (chain.size() < shortest || !isClear(asked.question.scene, ray)) continue;
        addRays(asked, ray);
        --count;
    }
}

}  // namespace

MirrorQuestion drawOpenScene(std::uint64_t seed) {
    Draw draw{seed, 105};
    MirrorQuestion asked;
    asked.question.scene = openScene(draw);
    addClearRays(draw, asked, 4, 3);
    addClearRays(draw, asked, 3, 3);
    addClearRays(draw, asked, 2, 4);
    addClearRays(draw, asked, 1, 5);
    addRays(asked, {{0.0, 0.0, 0.0}, Vector3{0.1, 0.9, -0.3}.normalised()});
    const Vector3 dull = asked.question.scene.spheres[kDull].centre + Vector3{0.0, 3.0, 0.0};
    addRays(asked, {dull, {0.0, -1.0, 0.0}});
    const Vector3 nearlyAll =
        asked.question.scene.spheres[kNearlyAll].centre + Vector3{0.0, 3.0, 0.0};
    addRays(asked, {nearlyAll, {0.0, -1.0, 0.0}});
    const Vector3 weak = asked.question.scene.spheres[kWeak].centre - Vector3{0.0, 3.0, 0.0};
    addRays(asked, {weak, {0.0, 1.0, 0.0}});
    askEachObject(asked);
    asked.question.eventCapacity = 2048;
    return asked;
}

MirrorQuestion drawFacingMirrors(std::uint64_t seed) {
    Draw draw{seed, 106};
    MirrorQuestion asked;
    SceneDescription& scene = asked.question.scene;
    const auto around = [&](double value) { return value + draw.between(-0.1, 0.1); };
    scene.ambientLighting = draw.colour(0.02, 0.1);
    scene.pointLights.emplace_back(Vector3{around(1.0), around(2.0), around(1.0)},
                                   draw.colour(0.4, 1.0), kBright);
    scene.planes.push_back({{0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}, materialWith(draw, 0.5)});
    scene.planes.push_back({{0.0, 0.0, 6.0}, {0.0, around(-0.6), -1.0}, materialWith(draw, 0.45)});
    Ray ray{{around(0.0), around(0.5), 0.0}, Vector3{around(0.0), -0.6, 0.8}.normalised()};
    asked.direct.scene = scene;
    for (int bounces = 0; bounces < kMostBounces; ++bounces) {
        asked.question.rays.push_back({0, bounces, ray.origin, ray.direction});
        if (const auto nearest = nearestOn(scene, ray)) {
            const Meeting& at = nearest->meeting;
            asked.direct.points.push_back({nearest->object, at.location, at.normal, ray.origin});
            ray = {at.location + at.normal * 1e-4, (-ray.direction).reflectIn(at.normal)};
        }
    }
    for (probe::CastRay& cast : asked.question.rays) {
        cast.origin = asked.question.rays[0].origin;
        cast.direction = asked.question.rays[0].direction;
    }
    return asked;
}

MirrorQuestion drawDeepMirrors(std::uint64_t seed) {
    constexpr double kShare = 0.9;  // so that a third of the light comes from beyond ten mirrors
    Draw draw{seed, 108};
    MirrorQuestion asked;
    SceneDescription& scene = asked.question.scene;
    scene.ambientLighting = ColourRGB{0.5};
    const Vector3 floor{draw.between(-1.0, 1.0), draw.between(-1.0, 1.0), draw.between(3.0, 5.0)};
    const Vector3 up = draw.direction();
    const double height = draw.between(2.0, 4.0);
    for (const bool isBright : {false, true}) {
        Material material;
        material.colour = isBright ? draw.colour(0.7, 0.9) : draw.colour(0.1, 0.3);
        material.reflectivity = kShare;
        scene.planes.push_back(
            {isBright ? floor + up * height : floor, isBright ? -up : up, material});
    }
    const Vector3 direction = draw.directionAround(-up, 0.9);
    for (const int bounces : {4, 5, 6, 7, 8, 9, 10, kDeepest})
        asked.question.rays.push_back({0, bounces, floor + up * (height / 2.0), direction});
    askEachObject(asked);
    return asked;
}

MirrorQuestion drawGrazedMirror(std::uint64_t seed) {
    Draw draw{seed, 112};
    MirrorQuestion asked;
    SceneDescription& scene = asked.question.scene;
    scene.ambientLighting = ColourRGB{0.5};
    const Vector3 foot{draw.between(-1.0, 1.0), draw.between(-1.0, 1.0), draw.between(3.0, 5.0)};
    const Vector3 up = draw.direction();
    const Vector3 along = perpendicularsOf(up).first;
    Material wall = materialWith(draw, 0.0);
    wall.colour = wall.colour * 0.1;
    scene.planes.push_back({foot, up, materialWith(draw, 0.6)});
    scene.planes.push_back({foot + along * draw.between(4.0, 6.0), -along, wall});
    const double height = draw.between(0.02, 0.04);
    const Vector3 direction = (along - up * height).normalised();
    const Vector3 origin = foot - direction * draw.between(1.5, 4.0);
    for (const int bounces : {1, 2})
        asked.question.rays.push_back({0, bounces, origin, direction});
    askEachObject(asked);
    return asked;
}

ColourRGB alongChain(const MirrorQuestion& asked, const std::vector<ColourRGB>& direct,
                     int bounces) {
    ColourRGB colour = direct[static_cast<std::size_t>(bounces)];
    for (int i = bounces; i-- > 0;) {
        const auto at = static_cast<std::size_t>(i);
        const double share =
            materialOf(asked.question.scene, asked.direct.points[at].object).reflectivity;
        colour = direct[at] * (1.0 - share) + colour * share;
    }
    return colour;
}

}  // namespace ticker::tasks::maintick
