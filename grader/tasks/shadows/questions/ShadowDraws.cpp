#include <grader/tasks/shadows/questions/ShadowDraws.h>

#include <raytracer/render/Renderer.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace ticker::tasks {
namespace {

// Aim points all over the light decide. The ball is taken a third larger, so that no accepted
// sample and no accepted bias is near a decision.
Zone zoneOf(const Surfaces& surfaces, const Vector3& start, const Vector3& light, double radius) {
    const double share = visibleShare(surfaces, start, light, radius * 4.0 / 3.0);
    if (share == 1.0) return Zone::lit;
    return share == 0.0 ? Zone::umbra : Zone::penumbra;
}

constexpr int kSpiralPlaces = 96;

// A spiral of equal areas over the unit sphere (golden angle).
std::array<Vector3, kSpiralPlaces> spiral() {
    std::array<Vector3, kSpiralPlaces> places;
    for (int i = 0; i < kSpiralPlaces; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / kSpiralPlaces;
        const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
        const double ring = std::sqrt(1.0 - z * z);
        places.at(static_cast<std::size_t>(i)) = {ring * std::cos(angle), ring * std::sin(angle),
                                                  z};
    }
    return places;
}

}  // namespace

double visibleShare(const Surfaces& surfaces, const Vector3& start, const Vector3& centre,
                    double radius) {
    static const std::array<Vector3, kSpiralPlaces> kSpiral = spiral();
    int open = 0;
    for (const Vector3& place : kSpiral) {
        const Vector3 towards = centre + place * radius - start;
        const double distance = towards.magnitude();
        if (surfaces.sightAlong(start, towards / distance, distance) == Sight::open) ++open;
    }
    return static_cast<double>(open) / kSpiralPlaces;
}

raytracer::Material drawMaterial(Draw& draw) {
    raytracer::Material material;
    material.colour = draw.colour(0.2, 0.9);
    material.phongKD = draw.between(0.5, 0.95);
    material.phongKS = draw.between(0.7, 1.4);
    material.phongAlpha = std::floor(draw.between(6.0, 14.0));
    material.reflectivity = draw.between(0.1, 0.5);
    return material;
}

raytracer::PointLight drawLight(Draw& draw, const Vector3& position, double distance) {
    const double intensity = 4.0 * std::numbers::pi * distance * distance;
    return {position, draw.colour(0.4, 1.0), intensity * draw.between(0.7, 1.3)};
}

Vector3 sideAt(const Perpendiculars& sides, double angle) {
    return sides.first * std::cos(angle) + sides.second * std::sin(angle);
}

Vector3 drawPlace(Draw& draw) {
    const double x = draw.between(-1.0, 1.0);
    const double y = draw.between(-1.0, 1.0);
    return {x, y, draw.between(5.0, 7.0)};
}

Vector3 drawViewer(Draw& draw, const Vector3& point, const Vector3& normal, const Vector3& light) {
    const Vector3 mirrored = (light - point).normalised().reflectIn(normal);
    Vector3 towards = draw.directionAround(mirrored, 0.6);
    while (towards.dot(normal) < 0.1)
        towards = draw.directionAround(mirrored, 0.6);
    return point + towards * draw.between(3.0, 5.0);
}

Vector3 drawLensPoint(Draw& draw, const raytracer::RenderSettings& settings) {
    const double x = draw.between(-settings.dofAmount, settings.dofAmount);
    return {x, draw.between(-settings.dofAmount, settings.dofAmount), 0.0};
}

Vector3 rayStart(const Vector3& point, const Vector3& normal) {
    return point + normal * raytracer::kShadowBias;
}

std::vector<Zone> zonesOf(const raytracer::SceneDescription& scene, const Surfaces& surfaces,
                          const Vector3& point, const Vector3& normal, double radius) {
    std::vector<Zone> zones;
    for (const raytracer::PointLight& light : scene.pointLights)
        zones.push_back(zoneOf(surfaces, rayStart(point, normal), light.position(), radius));
    return zones;
}

ShadowQuestion onFloor(Draw& draw, ShadowQuestion::Purpose purpose) {
    ShadowQuestion drawn;
    drawn.purpose = purpose;
    const Vector3 foot = drawPlace(draw);
    const Vector3 up = draw.directionAround((-foot).normalised(), 1.0);
    drawn.question.scene.planes.push_back({foot, up, drawMaterial(draw)});
    return drawn;
}

void addLightTowards(Draw& draw, ShadowQuestion& drawn, const Vector3& towards, double distance,
                     double share) {
    raytracer::SceneDescription& scene = drawn.question.scene;
    const Vector3 position = scene.planes.front().point + towards * distance;
    const raytracer::PointLight usual = drawLight(draw, position, distance);
    scene.pointLights.emplace_back(position, usual.colour(), usual.intensity() * share);
}

void addLitPoints(Draw& draw, ShadowQuestion& drawn, int count, double reach) {
    const raytracer::SceneDescription& scene = drawn.question.scene;
    const raytracer::PlaneDescription& floor = scene.planes.front();
    const Perpendiculars sides = perpendicularsOf(floor.normal);
    const Vector3 light = scene.pointLights.front().position();
    const int object = static_cast<int>(scene.spheres.size());
    for (int i = 0; i < count; ++i) {
        const double x = draw.between(-reach, reach);
        const Vector3 point =
            floor.point + sides.first * x + sides.second * draw.between(-reach, reach);
        const Vector3 viewer = drawViewer(draw, point, floor.normal, light);
        drawn.question.points.push_back({object, point, floor.normal, viewer});
        drawn.zones.emplace_back(scene.pointLights.size(), Zone::lit);
    }
    setCapacity(drawn);
}

void setCapacity(ShadowQuestion& question) {
    constexpr std::size_t kLogMargin = 8;
    const std::size_t rays = question.question.points.size() *
                             question.question.scene.pointLights.size() *
                             static_cast<std::size_t>(question.question.settings.shadowRayCount);
    question.question.eventCapacity = static_cast<std::uint32_t>(rays * kLogMargin);
}

}  // namespace ticker::tasks
