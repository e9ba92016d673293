#include <grader/tasks/maintick/TraceModel.h>
#include <grader/tasks/maintick/mixed/MixedPoints.h>
#include <grader/tasks/maintick/mixed/MixedShades.h>
#include <grader/tasks/support/Surfaces.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ticker::tasks::maintick {
namespace {

constexpr std::uint64_t kPointSeeds = 300;
using raytracer::PointLight;

Vector3 towards(const LitSetup& setup, const PointLight& light) {
    return (light.position() - setup.P).normalised();
}

/// The points of a seed, drawn once for all tests.
const std::vector<MixedPoint>& pointsOf(std::uint64_t seed) {
    static const auto kDrawn = [] {
        std::vector<std::vector<MixedPoint>> drawn;
        for (std::uint64_t each = 0; each < kPointSeeds; ++each)
            drawn.push_back(drawMixedPoints(each));
        return drawn;
    }();
    return kDrawn.at(seed);
}

/// A direction from one rounded place to another.
struct Floats {
    float x, y, z;
};
Floats wayOf(const Vector3& from, const Vector3& to) {
    return {static_cast<float>(to.x) - static_cast<float>(from.x),
            static_cast<float>(to.y) - static_cast<float>(from.y),
            static_cast<float>(to.z) - static_cast<float>(from.z)};
}
float dot(const Floats& a, const Floats& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Floats unit(const Floats& a) {
    const float length = std::sqrt(dot(a, a));
    return {a.x / length, a.y / length, a.z / length};
}

/// Everything in single precision, the power by a loop.
ColourRGB phongInFloats(const LitSetup& setup) {
    const raytracer::Material& material = setup.scene.spheres[0].material;
    const Floats N = wayOf({}, setup.N);
    const Floats V = unit(wayOf(setup.P, setup.O));
    ColourRGB colour = material.colour * setup.scene.ambientLighting;
    for (const PointLight& light : setup.scene.pointLights) {
        const Floats path = wayOf(setup.P, light.position());
        const Floats L = unit(path);
        const float facing = dot(N, L);
        const Floats R{2.0F * facing * N.x - L.x, 2.0F * facing * N.y - L.y,
                       2.0F * facing * N.z - L.z};
        const float mirrored = std::max(0.0F, dot(R, V));
        float power = 1.0F;
        for (int i = 0; i < static_cast<int>(material.phongAlpha); ++i)
            power *= mirrored;
        const ColourRGB I = light.illuminationAt(std::sqrt(dot(path, path)));
        colour += material.colour * I * (material.phongKD * std::max(0.0F, facing));
        colour += light.colour() * I * (material.phongKS * power);
    }
    return colour;
}

// Accepted readings differ at an edge, and in what a light behind the surface adds to a highlight.
TEST(MixedPoints, KeepAllCosinesOffTheirEdges) {
    for (std::uint64_t seed = 0; seed < kPointSeeds; ++seed) {
        std::vector<LitSetup> setups;
        for (const MixedPoint& point : pointsOf(seed))
            setups.push_back(point.alone);
        for (const MixedShade& shade : drawMixedShades(seed))
            setups.push_back(shade.point.alone);
        for (const LitSetup& setup : setups) {
            const Vector3 V = (setup.O - setup.P).normalised();
            EXPECT_GT(V.dot(setup.N), 0.0199) << seed;
            for (const PointLight& light : setup.scene.pointLights) {
                const Vector3 L = towards(setup, light);
                const double mirrored = L.reflectIn(setup.N).dot(V);
                EXPECT_GT(std::abs(L.dot(setup.N)), 0.0199) << seed;
                EXPECT_GT(std::abs(mirrored), 0.0199) << seed;
                if (L.dot(setup.N) < 0.0) {
                    EXPECT_LT(mirrored, 0.0) << seed;
                }
                const double distance = (light.position() - setup.P).magnitude();
                EXPECT_GT(distance, 0.199) << seed;
                EXPECT_LT(distance, 60.01) << seed;
            }
        }
    }
}

TEST(MixedPoints, AreRightInSinglePrecision) {
    for (std::uint64_t seed = 0; seed < kPointSeeds; ++seed)
        for (const MixedPoint& point : pointsOf(seed))
            EXPECT_TRUE(isNear(phongInFloats(point.alone), phong(point.alone), 0.6 * kTolerance))
                << seed << words(phong(point.alone)) << words(phongInFloats(point.alone));
}

/// Whether no object lies on the line to the light or beyond it, wherever a shadow ray starts, and
/// a ray from the light meets the point first.
bool isFree(const MixedPoint& point, const PointLight& light) {
    const Vector3 L = towards(point.alone, light);
    const Vector3& P = point.alone.P;
    for (const Vector3& up : {point.alone.N * 1e-6, point.alone.N * 1e-3, L * 1e-3})
        if (nearestOn(point.scene, {P + up, L})) return false;
    const auto from = nearestOn(point.scene, {light.position(), -L});
    return from && from->object == point.object && (from->meeting.location - P).magnitude() < 1e-9;
}

TEST(MixedPoints, LieOnTheirObjectWithAllLightsFree) {
    for (std::uint64_t seed = 0; seed < kPointSeeds; ++seed)
        for (const MixedPoint& point : pointsOf(seed)) {
            const auto spheres = static_cast<int>(point.scene.spheres.size());
            EXPECT_EQ(point.object >= spheres, point.isOnPlane);
            EXPECT_EQ(tasks::materialOf(point.scene, point.object).phongAlpha,
                      point.alone.scene.spheres[0].material.phongAlpha);
            for (const PointLight& light : point.scene.pointLights)
                if (towards(point.alone, light).dot(point.alone.N) > 0.0) {
                    EXPECT_TRUE(isFree(point, light)) << seed;
                }
        }
}

/// Expects that at least `least` points of each seed fit.
template <class Fits>
void expectAtLeast(int least, const char* what, const Fits& fits) {
    for (std::uint64_t seed = 0; seed < kPointSeeds; ++seed) {
        int count = 0;
        for (const MixedPoint& point : pointsOf(seed))
            count += fits(point, point.alone.scene.spheres[0].material) ? 1 : 0;
        EXPECT_GE(count, least) << what << ", seed " << seed;
    }
}

TEST(MixedPoints, HaveEachExtremeUnderEverySeed) {
    using P = MixedPoint;
    using M = raytracer::Material;
    for (const std::size_t lights : {0U, 1U, 2U, 3U, 6U})
        expectAtLeast(3, "lights",
                      [&](const P& p, const M&) { return p.scene.pointLights.size() == lights; });
    for (const double share : {0.0, 0.03, 0.5, 0.97, 1.0})
        expectAtLeast(4, "share", [&](const P&, const M& m) { return m.reflectivity == share; });
    for (const double alpha : {1.0, 2.0, 7.0, 40.0, 280.0})
        expectAtLeast(3, "alpha", [&](const P&, const M& m) { return m.phongAlpha == alpha; });
    for (const double kd : {0.0, 0.5, 1.0, 2.0})
        expectAtLeast(6, "kd", [&](const P&, const M& m) { return m.phongKD == kd; });
    for (const double ks : {0.0, 0.5, 1.4})
        expectAtLeast(8, "ks", [&](const P&, const M& m) { return m.phongKS == ks; });
    expectAtLeast(4, "black", [](const P&, const M& m) { return m.colour == ColourRGB{}; });
    expectAtLeast(4, "no ambient light",
                  [](const P& p, const M&) { return p.scene.ambientLighting == ColourRGB{}; });
    expectAtLeast(12, "plane", [](const P& p, const M&) { return p.isOnPlane; });
    expectAtLeast(6, "behind the camera", [](const P& p, const M&) { return p.alone.P.z < 0.0; });
    expectAtLeast(4, "viewer behind", [](const P& p, const M&) { return p.alone.O.z < 0.0; });
    expectAtLeast(4, "far", [](const P& p, const M&) { return p.alone.P.magnitude() > 29.9; });
    expectAtLeast(4, "negative",
                  [](const P& p, const M&) { return p.alone.P.x < 0.0 && p.alone.P.y < 0.0; });
    expectAtLeast(12, "others", [](const P& p, const M&) {
        return p.scene.spheres.size() + p.scene.planes.size() > 2;
    });
}

/// What code with a condition on some attribute of a scene might leave out.
enum class Lost : std::uint8_t { ambient, diffuse, highlight, lights };

LitSetup without(Lost lost, LitSetup setup) {
    raytracer::Material& material = setup.scene.spheres[0].material;
    if (lost == Lost::ambient) setup.scene.ambientLighting = {};
    if (lost == Lost::diffuse) material.phongKD = 0.0;
    if (lost == Lost::highlight) material.phongKS = 0.0;
    if (lost == Lost::lights) setup.scene.pointLights.clear();
    return setup;
}

/// Expects under every seed a point where `holds` and whose colour changes clearly without the lost
/// part, for each of `all`.
template <class Holds>
void expectShown(const char* what, std::initializer_list<Lost> all, const Holds& holds) {
    for (const Lost lost : all) {
        int unseen = 0;
        for (std::uint64_t seed = 0; seed < kPointSeeds; ++seed) {
            const auto& points = pointsOf(seed);
            const bool shows = std::ranges::any_of(points, [&](const MixedPoint& point) {
                return holds(point, point.alone.scene.spheres[0].material) &&
                       !isNear(phong(without(lost, point.alone)), phong(point.alone),
                               2.0 * kTolerance);
            });
            unseen += shows ? 0 : 1;
        }
        EXPECT_EQ(unseen, 0) << what << ", " << static_cast<int>(lost);
    }
}

TEST(MixedPoints, ShowAnyConditionOnTheSurface) {
    using P = MixedPoint;
    using M = raytracer::Material;
    using enum Lost;
    for (const double share : {0.0, 0.03, 0.5, 0.97, 1.0})
        expectShown("share", {ambient, diffuse, highlight, lights},
                    [&](const P&, const M& m) { return m.reflectivity == share; });
    for (const double alpha : {1.0, 2.0, 7.0, 40.0, 280.0})
        expectShown("alpha", {ambient, diffuse, highlight, lights},
                    [&](const P&, const M& m) { return m.phongAlpha == alpha; });
    for (const double kd : {0.0, 0.5, 1.0, 2.0})
        expectShown("kd", {ambient, highlight, lights},
                    [&](const P&, const M& m) { return m.phongKD == kd; });
    for (const double ks : {0.0, 0.5, 1.4})
        expectShown("ks", {ambient, diffuse, lights},
                    [&](const P&, const M& m) { return m.phongKS == ks; });
    expectShown("black", {highlight}, [](const P&, const M& m) { return m.colour == ColourRGB{}; });
    const std::initializer_list<Lost> every{ambient, diffuse, highlight, lights};
    expectShown("plane", every, [](const P& p, const M&) { return p.isOnPlane; });
    expectShown("z", every, [](const P& p, const M&) { return p.alone.P.z < 0.0; });
    expectShown("viewer", every, [](const P& p, const M&) { return p.alone.O.z < 0.0; });
    expectShown("far", every, [](const P& p, const M&) { return p.alone.P.magnitude() > 20.0; });
}

TEST(MixedPoints, ShowAnyConditionOnTheLights) {
    using P = MixedPoint;
    using M = raytracer::Material;
    using enum Lost;
    const std::initializer_list<Lost> every{ambient, diffuse, highlight, lights};
    for (const std::size_t count : {1U, 2U, 3U, 6U})
        expectShown("lights", every,
                    [&](const P& p, const M&) { return p.scene.pointLights.size() == count; });
    expectShown("no light", {ambient},
                [](const P& p, const M&) { return p.scene.pointLights.empty(); });
    expectShown("no ambient light", {diffuse, highlight, lights},
                [](const P& p, const M&) { return p.scene.ambientLighting == ColourRGB{}; });
    const auto anyLight = [](const char* what, std::initializer_list<Lost> all, auto&& fits) {
        expectShown(what, all, [&](const P& p, const M&) {
            return std::ranges::any_of(p.scene.pointLights, [&](const PointLight& light) {
                return fits(light, (light.position() - p.alone.P).magnitude());
            });
        });
    };
    anyLight("near", every, [](const PointLight&, double d) { return d < 1.0; });
    anyLight("very near", every, [](const PointLight&, double d) { return d < 0.5; });
    anyLight("distant", every, [](const PointLight&, double d) { return d > 20.0; });
    anyLight("faint", every, [](const PointLight& l, double d) {
        const ColourRGB I = l.illuminationAt(d);
        return std::max({I.r, I.g, I.b}) < 1.0 / 255.0;
    });
    anyLight("bright", every, [](const PointLight& l, double d) {
        const ColourRGB I = l.illuminationAt(d);
        return std::max({I.r, I.g, I.b}) > 10.0;
    });
    for (const auto channel : {&ColourRGB::r, &ColourRGB::g, &ColourRGB::b})
        anyLight("channel", every,
                 [&](const PointLight& l, double) { return l.colour().*channel == 0.0; });
}

}  // namespace
}  // namespace ticker::tasks::maintick
