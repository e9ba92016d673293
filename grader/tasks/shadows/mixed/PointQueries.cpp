#include <grader/tasks/shadows/mixed/PointQueries.h>
#include <grader/tasks/shadows/questions/ShadowDraws.h>

#include <cstddef>

namespace ticker::tasks {
namespace {

Vector3 startOf(const PointOfLog& at) {
    return rayStart(at.point->point.position, at.point->point.normal);
}

}  // namespace

const raytracer::Material& surfaceOf(const PointOfLog& at) {
    return materialOf(at.log->scene(), at.point->point.object);
}

double distanceOf(const PointOfLog& at, const raytracer::PointLight& light) {
    return (light.position() - at.point->point.position).magnitude();
}

bool isInFront(const PointOfLog& at, const raytracer::PointLight& light) {
    return (light.position() - at.point->point.position).dot(at.point->point.normal) > 0.0;
}

int channelsOf(const ColourRGB& colour) {
    return (colour.r > 0.0 ? 1 : 0) + (colour.g > 0.0 ? 1 : 0) + (colour.b > 0.0 ? 1 : 0);
}

bool anyBlockerThat(
    const PointOfLog& at,
    const std::function<bool(const raytracer::SceneDescription&, int object)>& test) {
    const raytracer::SceneDescription& scene = at.log->scene();
    const Vector3 start = startOf(at);
    const int objects = static_cast<int>(scene.spheres.size() + scene.planes.size());
    for (int i = 0; i < objects; ++i) {
        if (i == at.point->point.object || !test(scene, i)) continue;
        raytracer::SceneDescription alone;
        const auto index = static_cast<std::size_t>(i);
        if (index < scene.spheres.size())
            alone.spheres = {scene.spheres[index]};
        else
            alone.planes = {scene.planes[index - scene.spheres.size()]};
        const Surfaces surfaces{alone};
        const bool blocks = anyLight(at, [&](const raytracer::PointLight& light) {
            const Vector3 way = light.position() - start;
            return isInFront(at, light) &&
                   surfaces.sightAlong(start, way.normalised(), way.magnitude()) == Sight::blocked;
        });
        if (blocks) return true;
    }
    return false;
}

bool anyBlocker(const PointOfLog& at, const std::function<bool(const raytracer::Material&)>& test) {
    return anyBlockerThat(at, [&](const raytracer::SceneDescription& scene, int object) {
        return test(materialOf(scene, object));
    });
}

bool anyBlockerWithin(const PointOfLog& at, double distance) {
    const Surfaces surfaces{at.log->scene()};
    const Vector3 start = startOf(at);
    return anyLight(at, [&](const raytracer::PointLight& light) {
        const Vector3 way = light.position() - start;
        const double length = way.magnitude();
        return isInFront(at, light) &&
               surfaces.sightAlong(light.position(), -way / length, std::min(distance, length)) ==
                   Sight::blocked;
    });
}

const raytracer::SphereDescription* sphereOf(const raytracer::SceneDescription& scene, int object) {
    const auto index = static_cast<std::size_t>(object);
    return index < scene.spheres.size() ? &scene.spheres[index] : nullptr;
}

}  // namespace ticker::tasks
