#include <grader/tasks/maintick/mixed/MirrorLinks.h>

#include <grader/tasks/maintick/PhongModel.h>
#include <grader/tasks/maintick/mixed/Edges.h>
#include <grader/tasks/support/Surfaces.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace ticker::tasks::maintick {
namespace {

using raytracer::PointLight;
using raytracer::SceneDescription;

constexpr double kWhole = std::numeric_limits<double>::infinity();

// With the largest bias a hit moves by at most a hundredth, and the ray turns by as much: twice as
// far with twice the bias.
constexpr double kTwiceTheBias = 2e-3;
constexpr double kMostMoved = 0.02;
constexpr Margin kMirrorMargin{0.02, 0.015};

Sight sightOfObject(const SceneDescription& scene, int object, const Ray& ray, double reach) {
    const auto at = static_cast<std::size_t>(object);
    return at < scene.spheres.size()
               ? sightOf(scene.spheres[at], ray, reach, kMirrorMargin)
               : sightOf(scene.planes[at - scene.spheres.size()], ray, reach, kMirrorMargin);
}

/// Whether the link is on another object, or its point or the ray that leaves it has moved by more
/// than `kMostMoved`.
bool hasMoved(const MirrorLink& link, const MirrorLink& usual) {
    const auto leaves = [](const MirrorLink& at) {
        return (at.O - at.P).normalised().reflectIn(at.N);
    };
    return link.object != usual.object || (link.P - usual.P).magnitude() > kMostMoved ||
           (leaves(link) - leaves(usual)).magnitude() > kMostMoved;
}

/// Whether the ray meets `met` (-1: nothing) off all edges. It starts on `from`.
bool isClearWay(const SceneDescription& scene, const Ray& ray, int from, int met, double reach) {
    const auto count = static_cast<int>(scene.spheres.size() + scene.planes.size());
    for (int object = 0; object < count; ++object) {
        if (object == from) continue;
        const bool isMet = object == met;
        if (sightOfObject(scene, object, ray, isMet ? kWhole : reach) !=
            (isMet ? Sight::blocked : Sight::open))
            return false;
    }
    return true;
}

}  // namespace

std::vector<MirrorLink> linksOf(const SceneDescription& scene, Ray ray, const MirrorStart& start) {
    std::vector<MirrorLink> links;
    while (links.size() < kMostLinks) {
        const auto nearest = nearestOn(scene, ray);
        if (!nearest) break;
        const Meeting& at = nearest->meeting;
        links.push_back({nearest->object, materialOf(scene, nearest->object).reflectivity,
                         at.location, at.normal, ray.origin});
        const Vector3 R = (-ray.direction).reflectIn(at.normal);
        ray = {at.location + (start.isAlongRay ? R : at.normal) * start.bias, R};
    }
    return links;
}

std::vector<ColourRGB> directOf(const SceneDescription& scene,
                                const std::vector<MirrorLink>& links) {
    std::vector<ColourRGB> direct;
    for (const MirrorLink& link : links) {
        LitSetup setup{{}, link.P, link.N, link.O};
        setup.scene.ambientLighting = scene.ambientLighting;
        setup.scene.spheres.push_back({{}, 1.0, materialOf(scene, link.object), nullptr});
        for (const PointLight& light : scene.pointLights) {
            const Vector3 way = light.position() - link.P;
            const auto hit = nearestOn(scene, {link.P + link.N * 1e-4, way.normalised()});
            if (!hit || hit->meeting.distance > way.magnitude())
                setup.scene.pointLights.push_back(light);
        }
        direct.push_back(phong(setup));
    }
    return direct;
}

bool areOffEdges(const SceneDescription& scene, const Ray& ray,
                 const std::vector<MirrorLink>& links) {
    constexpr double kFront = -0.05;  // D.N
    constexpr double kBehind = 0.25;  // where surfaces meet, either may be met first
    int from = -1;
    Ray next = ray;
    for (const MirrorLink& link : links) {
        const double distance = (link.P - next.origin).magnitude() + kBehind;
        if (next.direction.dot(link.N) > kFront ||
            !isClearWay(scene, next, from, link.object, distance))
            return false;
        from = link.object;
        next = {link.P, (-next.direction).reflectIn(link.N)};
    }
    return links.size() == kMostLinks || isClearWay(scene, next, from, -1, kWhole);
}

bool areLightsClear(const SceneDescription& scene, const std::vector<MirrorLink>& links) {
    constexpr double kLow = 0.03;
    return std::ranges::all_of(links, [&](const MirrorLink& link) {
        return std::ranges::all_of(scene.pointLights, [&](const PointLight& light) {
            const Vector3 way = light.position() - link.P;
            const double facing = way.normalised().dot(link.N);
            return std::abs(facing) > kLow &&
                   (facing < 0.0 || sightOf(scene, {link.P, way.normalised()}, way.magnitude(),
                                            link.object, kMirrorMargin) != Sight::unsure);
        });
    });
}

bool isSteady(const SceneDescription& scene, const Ray& ray, const std::vector<MirrorLink>& links) {
    constexpr double kChange = kMirrorTolerance / 5.0;
    const std::vector<ColourRGB> direct = directOf(scene, links);
    for (const MirrorStart& start :
         {MirrorStart{kTwiceTheBias, false}, MirrorStart{kTwiceTheBias, true},
          MirrorStart{1e-6, false}, MirrorStart{1e-6, true}}) {
        const std::vector<MirrorLink> moved = linksOf(scene, ray, start);
        if (!std::ranges::equal(moved, links, std::not_fn(hasMoved))) return false;
        if (scene.pointLights.empty()) continue;
        const std::vector<ColourRGB> movedDirect = directOf(scene, moved);
        for (std::size_t i = 0; i < links.size(); ++i) {
            MirrorLink above = links[i];
            above.P += above.N * 1e-3;
            if (!isNear(movedDirect[i], direct[i], 2.0 * kChange) ||
                !isNear(directOf(scene, {above})[0], direct[i], kChange))
                return false;
        }
    }
    return true;
}

}  // namespace ticker::tasks::maintick
