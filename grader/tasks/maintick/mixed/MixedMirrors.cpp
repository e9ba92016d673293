#include <grader/tasks/maintick/mixed/MixedMirrors.h>

#include <grader/tasks/maintick/mixed/MixedPoints.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace ticker::tasks::maintick {
namespace {

using raytracer::Material;
using raytracer::PointLight;
using raytracer::SceneDescription;

struct LinkPlan {
    Material material;
    bool isPlane;
};

struct Plan {
    Region region;
    std::vector<LinkPlan> links;
    int lights;
    double brightness;
    bool hasAmbient;
};

class Plans {
public:
    explicit Plans(Draw& draw)
        : materials_(draw),
          region_(draw, {Region::usual, Region::behindCamera, Region::negative, Region::farOff}),
          length_(draw, {1, 2, 3, 3, 4, 5}),
          lights_(draw, {0, 0, 0, 1, 2}),
          brightness_(draw, {0.02, 1.0, 5.0}),
          hasAmbient_(draw, {true, true, false}),
          isPlane_(draw, {true, false, false}),
          shares_(kMostLinks, Deck<double>{draw, {0.0, 0.03, 0.5, 0.97, 1.0, 0.0, 1.0}}) {
        // A dull surface ends the chain, and what a weak one shows hardly counts: the first surface
        // is a strong mirror more often than the others.
        shares_[0] = Deck<double>{draw, {0.0, 0.03, 0.5, 0.97, 1.0, 0.5, 0.97, 1.0}};
    }

    [[nodiscard]] Plan deal() {
        Plan plan{region_.deal(), {}, lights_.deal(), brightness_.deal(), hasAmbient_.deal()};
        const auto length = static_cast<std::size_t>(length_.deal());
        for (std::size_t i = 0; i < length; ++i) {
            plan.links.push_back({materials_.deal(), isPlane_.deal()});
            plan.links.back().material.reflectivity = shares_[i].deal();
        }
        return plan;
    }
    [[nodiscard]] Material material() { return materials_.deal(); }

private:
    MixedMaterials materials_;
    Deck<Region> region_;
    Deck<int> length_;
    Deck<int> lights_;
    Deck<double> brightness_;
    Deck<bool> hasAmbient_;
    Deck<bool> isPlane_;
    std::vector<Deck<double>> shares_;
};

/// Puts a mirror on the ray.
/// @return  The mirrored ray.
Ray addMirror(Draw& draw, SceneDescription& scene, const Ray& ray, const LinkPlan& plan) {
    const Vector3 P = ray.evaluateAt(logBetween(draw, 0.3, 8.0));
    const Vector3 N = draw.directionAround(-ray.direction, 1.2);
    if (plan.isPlane) {
        const Vector3 along = perpendicularsOf(N).first * draw.between(-3.0, 3.0);
        scene.planes.push_back({P + along, N, plan.material});
    } else {
        const double radius = logBetween(draw, 0.3, 3.0);
        scene.spheres.push_back({P - N * radius, radius, plan.material, nullptr});
    }
    return {P, (-ray.direction).reflectIn(N)};
}

/// Lights before the first surface. Highlights are broad, so that they hardly change along with P.
void addLights(Draw& draw, SceneDescription& scene, const Plan& plan, const MirrorLink& first) {
    scene.ambientLighting = ColourRGB{0.0};
    if (plan.hasAmbient || plan.lights == 0)
        scene.ambientLighting = draw.colour(0.05, 0.3) * plan.brightness;
    for (int i = 0; i < plan.lights; ++i) {
        const double distance = logBetween(draw, 1.0, 30.0);
        const Vector3 way = draw.directionAround(first.N, 1.3) * distance;
        scene.pointLights.emplace_back(
            first.P + way, draw.colour(0.2, 1.0),
            plan.brightness * 4.0 * std::numbers::pi * distance * distance);
    }
    if (plan.lights == 0) return;
    constexpr double kBroad = 7.0;
    for (auto& sphere : scene.spheres)
        sphere.material.phongAlpha = std::min(sphere.material.phongAlpha, kBroad);
    for (auto& plane : scene.planes)
        plane.material.phongAlpha = std::min(plane.material.phongAlpha, kBroad);
}

/// Builds the planned chain; empty if the ray meets another chain, or one too near to an edge.
std::optional<MixedMirror> build(Draw& draw, const Plan& plan, Plans& plans) {
    MixedMirror mirror;
    SceneDescription& scene = mirror.scene;
    mirror.ray = {placeIn(draw, plan.region), draw.direction()};
    Ray next = mirror.ray;
    for (const LinkPlan& link : plan.links)
        next = addMirror(draw, scene, next, link);
    for (int more = draw.whole(0, 2); more > 0; --more)
        scene.spheres.push_back({mirror.ray.origin + draw.direction() * draw.between(1.0, 8.0),
                                 draw.between(0.1, 0.8), plans.material(), nullptr});
    shuffle(draw, scene.spheres);
    shuffle(draw, scene.planes);
    mirror.links = linksOf(scene, mirror.ray, {});
    if (mirror.links.size() != plan.links.size() || !areOffEdges(scene, mirror.ray, mirror.links))
        return std::nullopt;
    addLights(draw, scene, plan, mirror.links.front());
    if (!areLightsClear(scene, mirror.links) || !isSteady(scene, mirror.ray, mirror.links))
        return std::nullopt;
    return mirror;
}

}  // namespace

std::vector<MixedMirror> drawMixedMirrors(std::uint64_t seed) {
    constexpr std::size_t kMirrors = 40;
    constexpr int kMostTries = 400;
    Draw draw{seed, 111};
    Plans plans{draw};
    std::vector<MixedMirror> mirrors;
    while (mirrors.size() < kMirrors) {
        const Plan plan = plans.deal();
        for (int tries = 0; tries < kMostTries; ++tries) {
            auto mirror = build(draw, plan, plans);
            if (!mirror) continue;
            mirrors.push_back(*std::move(mirror));
            break;
        }
    }
    return mirrors;
}

ColourRGB alongLinks(const MixedMirror& mirror, const std::vector<ColourRGB>& direct, int bounces) {
    const std::size_t count = mirror.links.size();
    auto last = std::min(count, static_cast<std::size_t>(bounces));
    for (std::size_t i = 0; i < last; ++i)
        if (mirror.links[i].share == 0.0) last = i;
    ColourRGB colour = last < count ? direct[last] : kBackground;
    for (std::size_t i = last; i-- > 0;) {
        const double share = mirror.links[i].share;
        colour = direct[i] * (1.0 - share) + colour * share;
    }
    return colour;
}

}  // namespace ticker::tasks::maintick
