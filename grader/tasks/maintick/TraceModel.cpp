#include <grader/tasks/maintick/TraceModel.h>

#include <grader/tasks/support/Surfaces.h>

namespace ticker::tasks::maintick {

std::optional<NearestObject> nearestOn(const raytracer::SceneDescription& scene, const Ray& ray) {
    std::optional<NearestObject> nearest;
    int object = 0;
    const auto look = [&](const std::optional<Meeting>& meeting) {
        if (meeting && (!nearest || meeting->distance < nearest->meeting.distance))
            nearest = {object, *meeting};
        ++object;
    };
    for (const auto& sphere : scene.spheres)
        look(meet(sphere, ray));
    for (const auto& plane : scene.planes)
        look(meet(plane, ray));
    return nearest;
}

ColourRGB TraceModel::along(const Ray& ray, int bounces, int depth, double before) const {
    constexpr int kDeepest = 40;
    const auto nearest = nearestOn(scene, ray);
    if (!nearest) return depth > 0 ? way.mirroredBackground : way.background;
    const raytracer::Material& material = materialOf(scene, nearest->object);
    const double share = material.reflectivity;
    const ColourRGB own = direct[static_cast<std::size_t>(nearest->object)];
    if (bounces <= way.last || share == 0.0 || share < way.weakest || depth > kDeepest)
        return way.endsDark ? own * (1.0 - share) : own;
    const Meeting& at = nearest->meeting;
    const Ray next{way.startsAtOrigin ? ray.origin : at.location + at.normal * way.bias,
                   way.mirrored(ray.direction, at.normal)};
    if (way.isDirectWhereNothingIsSeen && !nearestOn(scene, next)) return own;
    const int left = std::min(bounces - way.spent, way.most);
    return way.blend({own, along(next, left, depth + 1, share), share, before, material.colour});
}

std::vector<int> chainOf(const raytracer::SceneDescription& scene, Ray ray, int most,
                         const MirrorStart& start) {
    std::vector<int> chain;
    while (static_cast<int>(chain.size()) < most) {
        const auto nearest = nearestOn(scene, ray);
        if (!nearest) break;
        chain.push_back(nearest->object);
        const Vector3 R = (-ray.direction).reflectIn(nearest->meeting.normal);
        const Vector3 up = start.isAlongRay ? R : nearest->meeting.normal;
        ray = {nearest->meeting.location + up * start.bias, R};
    }
    return chain;
}

}  // namespace ticker::tasks::maintick
