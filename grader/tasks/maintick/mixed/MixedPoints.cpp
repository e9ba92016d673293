#include <grader/tasks/maintick/mixed/MixedPoints.h>

#include <grader/tasks/maintick/mixed/Edges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace ticker::tasks::maintick {
namespace {

using raytracer::PlaneDescription;
using raytracer::SphereDescription;

constexpr double ColourRGB::*kChannels[] = {&ColourRGB::r, &ColourRGB::g, &ColourRGB::b};

/// A direction at this cosine of the axis.
Vector3 atCosine(Draw& draw, const Vector3& axis, double cosine) {
    const Perpendiculars sides = perpendicularsOf(axis);
    const double around = draw.between(0.0, 2.0 * std::numbers::pi);
    const Vector3 side = sides.first * std::cos(around) + sides.second * std::sin(around);
    return axis * cosine + side * std::sqrt(1.0 - cosine * cosine);
}

/// Whether the object is clear of the rays from the point to all lights in front and beyond them,
/// and with `isBothWays` of the opposite rays, too.
template <class Object>
bool isAside(const LitSetup& setup, const Object& object, bool isBothWays) {
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    return std::ranges::all_of(setup.scene.pointLights, [&](const raytracer::PointLight& light) {
        if (facingOf(setup, light) < 0.0) return true;
        const Ray way = wayTo(setup, light);
        return sightOf(object, way, kEndless) == Sight::open &&
               (!isBothWays ||
                sightOf(object, {way.origin, -way.direction}, kEndless) == Sight::open);
    });
}

SphereDescription sphereAside(Draw& draw, const LitSetup& setup,
                              const raytracer::Material& material) {
    while (true) {
        const double distance = logBetween(draw, 0.4, 20.0);
        const SphereDescription sphere{setup.P + draw.direction() * distance,
                                       draw.between(0.1, 0.5) * distance, material, nullptr};
        if (isAside(setup, sphere, true)) return sphere;
    }
}

/// A plane below the surface, which no ray from the point to a light in front meets.
PlaneDescription planeAside(Draw& draw, const LitSetup& setup,
                            const raytracer::Material& material) {
    constexpr double kLeaning = 0.6;
    for (double most = kLeaning;; most *= 0.8) {
        const Vector3 normal = draw.directionAround(setup.N, most);
        const Vector3 below = setup.P - normal * logBetween(draw, 0.3, 10.0);
        const Vector3 along = perpendicularsOf(normal).first * draw.between(-3.0, 3.0);
        const bool isTurned = draw.whole(0, 1) == 1;
        const PlaneDescription plane{below + along, isTurned ? -normal : normal, material};
        if (isAside(setup, plane, false)) return plane;
    }
}

}  // namespace

MixedMaterials::MixedMaterials(Draw& draw)
    : draw_(&draw),
      paint_(draw, {Paint::any, Paint::any, Paint::any, Paint::any, Paint::oneBlack, Paint::black}),
      kd_(draw, {0.0, 0.5, 0.5, 1.0, 2.0}),
      ks_(draw, {0.0, 0.5, 1.4, 1.4}),
      alpha_(draw, {1.0, 2.0, 7.0, 40.0, 280.0}),
      reflectivity_(draw, {0.0, 0.03, 0.5, 0.97, 1.0}) {}

raytracer::Material MixedMaterials::deal() {
    raytracer::Material material;
    material.colour = draw_->colour(0.15, 0.95);
    const Paint paint = paint_.deal();
    if (paint == Paint::oneBlack) material.colour.*kChannels[draw_->whole(0, 2)] = 0.0;
    if (paint == Paint::black) material.colour = {};
    material.phongKD = kd_.deal();
    material.phongKS = ks_.deal();
    material.phongAlpha = alpha_.deal();
    material.reflectivity = reflectivity_.deal();
    return material;
}

double logBetween(Draw& draw, double low, double high) {
    return std::exp(draw.between(std::log(low), std::log(high)));
}

Vector3 placeIn(Draw& draw, Region region) {
    const auto aside = [&] { return draw.between(0.5, 4.0); };
    switch (region) {
        case Region::usual:
            return {draw.between(-2.0, 2.0), draw.between(-2.0, 2.0), draw.between(3.0, 6.0)};
        case Region::behindCamera:
            return {draw.between(-2.0, 2.0), draw.between(-2.0, 2.0), draw.between(-7.0, -1.0)};
        case Region::negative:
            return {-aside(), -aside(), draw.between(0.5, 6.0)};
        case Region::farOff:
            break;
    }
    return draw.direction() * draw.between(30.0, 60.0);
}

MixedPoints::MixedPoints(Draw& draw, std::vector<int> lights, bool hasLow)
    : draw_(&draw),
      materials_(draw),
      region_(draw, {Region::usual, Region::behindCamera, Region::negative, Region::farOff}),
      brightness_(draw, {1e-3, 0.03, 0.3, 3.0, 30.0}),
      hasAmbient_(draw, {false, true, true}),
      view_(draw, {View::highlight, View::highlight, View::anywhere, View::straight}),
      isPlane_(draw, {false, true}),
      lights_(draw, std::move(lights)),
      distance_(draw, {0.2, 0.4, 1.0, 3.0, 20.0}),
      hue_(draw, {Hue::white, Hue::oneChannel, Hue::any}),
      side_(draw, {Side::front, Side::front, Side::front, hasLow ? Side::low : Side::front,
                   Side::behind}) {}

MixedPoints::Plan MixedPoints::plan() {
    Plan plan{materials_.deal(),  region_.deal(), brightness_.deal(),
              hasAmbient_.deal(), view_.deal(),   {}};
    plan.lights.resize(static_cast<std::size_t>(lights_.deal()));
    for (LightPlan& light : plan.lights)
        light = {distance_.deal(), hue_.deal(), side_.deal()};
    return plan;
}

ColourRGB MixedPoints::colourOf(Hue hue) {
    if (hue == Hue::white) return ColourRGB{1.0};
    if (hue == Hue::any) return draw_->colour(0.2, 1.0);
    ColourRGB colour;
    colour.*kChannels[draw_->whole(0, 2)] = draw_->between(0.6, 1.0);
    return colour;
}

/// Adds a light that is as bright at the point as the others, so that each of them counts.
void MixedPoints::addLight(LitSetup& setup, const Plan& plan, const LightPlan& light) {
    const double facing = light.side == Side::front ? draw_->between(0.15, 0.99)
                          : light.side == Side::low ? draw_->between(0.03, 0.1)
                                                    : draw_->between(-0.95, -0.1);
    const double distance = logBetween(*draw_, light.nearest, 3.0 * light.nearest);
    const Vector3 way = atCosine(*draw_, setup.N, facing) * distance;
    const double arriving = plan.brightness * draw_->between(0.5, 1.5);
    setup.scene.pointLights.emplace_back(setup.P + way, colourOf(light.hue),
                                         arriving * 4.0 * std::numbers::pi * distance * distance);
}

/// @param view  A highlight is that of the first light in front.
Vector3 MixedPoints::viewerOf(const LitSetup& setup, View view) {
    const double distance = logBetween(*draw_, 0.5, 25.0);
    const auto& lights = setup.scene.pointLights;
    const auto front = std::ranges::find_if(
        lights, [&](const raytracer::PointLight& light) { return facingOf(setup, light) > 0.0; });
    if (view == View::highlight && front != lights.end()) {
        const double alpha = setup.scene.spheres[0].material.phongAlpha;
        const Vector3 R = wayTo(setup, *front).direction.reflectIn(setup.N);
        return setup.P + draw_->directionAround(R, 1.0 / std::sqrt(alpha)) * distance;
    }
    const double cosine =
        view == View::straight ? draw_->between(0.96, 1.0) : draw_->between(0.05, 0.95);
    return setup.P + atCosine(*draw_, setup.N, cosine) * distance;
}

LitSetup MixedPoints::place(const Plan& plan) {
    LitSetup setup;
    setup.P = placeIn(*draw_, plan.region);
    setup.N = draw_->direction();
    setup.scene.spheres.push_back({setup.P - setup.N * 3.0, 0.02, plan.material, nullptr});
    setup.scene.ambientLighting = ColourRGB{0.0};
    if (plan.hasAmbient)
        setup.scene.ambientLighting = draw_->colour(0.05, 0.3) * std::min(3.0, plan.brightness);
    for (const LightPlan& light : plan.lights)
        addLight(setup, plan, light);
    setup.O = viewerOf(setup, plan.view);
    return setup;
}

MixedPoint MixedPoints::deal() {
    constexpr int kMostTries = 60;  // far away single precision is too coarse for sharp highlights
    while (true) {
        const Plan planned = plan();
        const bool isPlane = isPlane_.deal();
        for (int tries = 0; tries < kMostTries; ++tries) {
            MixedPoint point{place(planned), isPlane};
            if (isOffEdges(point.alone) && isRightInFloats(point.alone)) return point;
        }
    }
}

void assemble(Draw& draw, MixedPoint& point, std::vector<SphereDescription> spheres,
              std::vector<PlaneDescription> planes) {
    const LitSetup& alone = point.alone;
    const raytracer::Material& material = alone.scene.spheres[0].material;
    const double height = draw.whole(0, 1) == 1 ? kRounding : -kRounding;
    const auto insert = [&](auto& objects, auto own) {
        const int at = draw.whole(0, static_cast<int>(objects.size()));
        objects.insert(objects.begin() + at, std::move(own));
        return at;
    };
    if (point.isOnPlane) {
        const Vector3 along = perpendicularsOf(alone.N).first * draw.between(-3.0, 3.0);
        point.object =
            static_cast<int>(spheres.size()) +
            insert(planes, PlaneDescription{alone.P - alone.N * height + along, alone.N, material});
    } else {
        const double radius = draw.between(0.4, 3.0);
        point.object = insert(spheres, SphereDescription{alone.P - alone.N * (radius + height),
                                                         radius, material, nullptr});
    }
    point.scene = alone.scene;
    point.scene.spheres = std::move(spheres);
    point.scene.planes = std::move(planes);
}

std::vector<MixedPoint> drawMixedPoints(std::uint64_t seed) {
    constexpr int kPoints = 100;
    Draw draw{seed, 109};
    MixedPoints points{draw, {0, 1, 1, 1, 2, 2, 3, 6}, false};  // M3.2 judges grazing light
    MixedMaterials materials{draw};
    Deck<int> others{draw, {0, 1, 2, 3, 5}};
    std::vector<MixedPoint> drawn;
    for (int i = 0; i < kPoints; ++i) {
        MixedPoint point = points.deal();
        std::vector<SphereDescription> spheres;
        std::vector<PlaneDescription> planes;
        for (int left = others.deal(); left > 0; --left)
            if (draw.whole(0, 2) < 2)
                spheres.push_back(sphereAside(draw, point.alone, materials.deal()));
            else
                planes.push_back(planeAside(draw, point.alone, materials.deal()));
        assemble(draw, point, std::move(spheres), std::move(planes));
        drawn.push_back(std::move(point));
    }
    return drawn;
}

}  // namespace ticker::tasks::maintick
