#include <grader/tasks/maintick/TraceModel.h>

#include <grader/tasks/support/Surfaces.h>

namespace ticker::tasks::maintick {
namespace {

constexpr ColourRGB kBackground{0.001};
constexpr int kDeepest = 40;

Ray mirrored(TraceMistake mistake, const Ray& ray, const Meeting& at) {
    const Vector3 D = ray.direction;
    Vector3 R = (-D).reflectIn(at.normal);
    if (mistake == TraceMistake::notNegated) R = D.reflectIn(at.normal);
    if (mistake == TraceMistake::straightOn) R = D;
    if (mistake == TraceMistake::straightBack) R = -D;
    if (mistake == TraceMistake::alongNormal) R = at.normal;
    Vector3 start = at.location + at.normal * 1e-4;
    if (mistake == TraceMistake::startAtOrigin) start = ray.origin;
    if (mistake == TraceMistake::startBelow) start = at.location - at.normal * 1e-4;
    return {start, R};
}

int nextBounces(TraceMistake mistake, int bounces) {
    if (mistake == TraceMistake::once) return 0;
    return mistake == TraceMistake::notLowered ? bounces : bounces - 1;
}

}  // namespace

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

ColourRGB TraceModel::blend(int object, const ColourRGB& mirrored) const {
    const raytracer::Material& material = materialOf(scene, object);
    const ColourRGB own = direct[static_cast<std::size_t>(object)];
    const double share = material.reflectivity;
    switch (mistake) {
        case TraceMistake::plusWhole:
            return own + mirrored;
        case TraceMistake::sharesExchanged:
            return own * share + mirrored * (1.0 - share);
        case TraceMistake::wholeDirect:
            return own + mirrored * share;
        case TraceMistake::wholeMirrored:
            return own * (1.0 - share) + mirrored;
        case TraceMistake::directLost:
            return mirrored * share;
        case TraceMistake::mirroredAlone:
            return mirrored;
        case TraceMistake::evenShares:
            return (own + mirrored) * 0.5;
        case TraceMistake::timesColour:
            return own * (1.0 - share) + mirrored * material.colour * share;
        default:
            return own * (1.0 - share) + mirrored * share;
    }
}

ColourRGB TraceModel::withReplacedWeight(Ray ray, int bounces) const {
    ColourRGB sum;
    double weight = 1.0;
    while (const auto nearest = nearestOn(scene, ray)) {
        const double share = materialOf(scene, nearest->object).reflectivity;
        const ColourRGB own = direct[static_cast<std::size_t>(nearest->object)];
        if (bounces-- == 0 || share == 0.0) return sum + own * weight;
        sum += own * ((1.0 - share) * weight);
        weight = share;
        ray = mirrored(mistake, ray, nearest->meeting);
    }
    return sum + kBackground * weight;
}

ColourRGB TraceModel::along(const Ray& ray, int bounces, int depth) const {
    if (mistake == TraceMistake::weightReplaced) return withReplacedWeight(ray, bounces);
    const auto nearest = nearestOn(scene, ray);
    const bool isBlack =
        mistake == TraceMistake::black || (mistake == TraceMistake::blackMirrored && depth > 0);
    if (!nearest) return isBlack ? ColourRGB{0.0} : kBackground;
    const double share = materialOf(scene, nearest->object).reflectivity;
    const ColourRGB own = direct[static_cast<std::size_t>(nearest->object)];
    const int last = mistake == TraceMistake::oneLess   ? 1
                     : mistake == TraceMistake::oneMore ? -1
                                                        : 0;
    constexpr double kWeak = 0.1;
    const bool isIgnored = mistake == TraceMistake::weakIgnored && share < kWeak;
    if (bounces <= last || share == 0.0 || isIgnored || depth > kDeepest ||
        mistake == TraceMistake::noMirror)
        return mistake == TraceMistake::baseReduced ? own * (1.0 - share) : own;
    const Ray next = mirrored(mistake, ray, nearest->meeting);
    if (mistake == TraceMistake::directWhereMirroredMisses && !nearestOn(scene, next)) return own;
    return blend(nearest->object, along(next, nextBounces(mistake, bounces), depth + 1));
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
