#include <grader/tasks/maintick/TraceModel.h>

#include <grader/tasks/support/Surfaces.h>

namespace ticker::tasks::maintick {
namespace {

constexpr ColourRGB kBackground{0.001};
constexpr int kDeepest = 40;

Ray mirrored(TraceSlip slip, const Ray& ray, const Meeting& at) {
    const Vector3 D = ray.direction;
    Vector3 R = (-D).reflectIn(at.normal);
    if (slip == TraceSlip::notNegated) R = D.reflectIn(at.normal);
    if (slip == TraceSlip::straightOn) R = D;
    if (slip == TraceSlip::straightBack) R = -D;
    if (slip == TraceSlip::alongNormal) R = at.normal;
    Vector3 start = at.location + at.normal * 1e-4;
    if (slip == TraceSlip::startAtOrigin) start = ray.origin;
    if (slip == TraceSlip::startBelow) start = at.location - at.normal * 1e-4;
    return {start, R};
}

int nextBounces(TraceSlip slip, int bounces) {
    if (slip == TraceSlip::once) return 0;
    return slip == TraceSlip::notLowered ? bounces : bounces - 1;
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
    switch (slip) {
        case TraceSlip::plusWhole:
            return own + mirrored;
        case TraceSlip::sharesExchanged:
            return own * share + mirrored * (1.0 - share);
        case TraceSlip::wholeDirect:
            return own + mirrored * share;
        case TraceSlip::wholeMirrored:
            return own * (1.0 - share) + mirrored;
        case TraceSlip::directLost:
            return mirrored * share;
        case TraceSlip::mirroredAlone:
            return mirrored;
        case TraceSlip::evenShares:
            return (own + mirrored) * 0.5;
        case TraceSlip::timesColour:
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
        ray = mirrored(slip, ray, nearest->meeting);
    }
    return sum + kBackground * weight;
}

ColourRGB TraceModel::along(const Ray& ray, int bounces, int depth) const {
    if (slip == TraceSlip::weightReplaced) return withReplacedWeight(ray, bounces);
    const auto nearest = nearestOn(scene, ray);
    const bool isBlack =
        slip == TraceSlip::black || (slip == TraceSlip::blackMirrored && depth > 0);
    if (!nearest) return isBlack ? ColourRGB{0.0} : kBackground;
    const double share = materialOf(scene, nearest->object).reflectivity;
    const ColourRGB own = direct[static_cast<std::size_t>(nearest->object)];
    const int last = slip == TraceSlip::oneLess ? 1 : slip == TraceSlip::oneMore ? -1 : 0;
    constexpr double kWeak = 0.1;
    const bool isIgnored = slip == TraceSlip::weakIgnored && share < kWeak;
    if (bounces <= last || share == 0.0 || isIgnored || depth > kDeepest ||
        slip == TraceSlip::noMirror)
        return slip == TraceSlip::baseReduced ? own * (1.0 - share) : own;
    const Ray next = mirrored(slip, ray, nearest->meeting);
    if (slip == TraceSlip::directWhereMirroredMisses && !nearestOn(scene, next)) return own;
    return blend(nearest->object, along(next, nextBounces(slip, bounces), depth + 1));
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
