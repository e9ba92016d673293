// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <array>
#include <functional>
#include <unordered_map>

namespace raytracer {
namespace {

struct Cell {
    std::array<long, 3> at;
    friend bool operator==(const Cell&, const Cell&) = default;
    static Cell of(const Vector3& p) {
        constexpr double kSide = 1e-9;
        return {{std::lround(p.x / kSide), std::lround(p.y / kSide), std::lround(p.z / kSide)}};
    }
};

struct HashCell {
    std::size_t operator()(const Cell& c) const {
        std::size_t h = 0;
        for (const long v : c.at) h = h * 1099511628211U + std::hash<long>{}(v);
        return h;
    }
};

}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 toViewer = (O - P).normalised();
    ColourRGB colour = object.colour() * scene.ambientLighting();
    std::unordered_map<Cell, double, HashCell> known;  // shares by place, for this call

    for (const PointLight& light : scene.pointLights()) {
        const double distance = (light.position() - P).magnitude();
        const Vector3 toLight = (light.position() - P).normalised();
        const ColourRGB arriving = light.illuminationAt(distance);

        const double facing = std::max(0.0, N.dot(toLight));
        const ColourRGB diffuse = object.colour() * arriving * (object.phongKD() * facing);

        const double mirrored = std::max(0.0, toLight.reflectIn(N).dot(toViewer));
        const ColourRGB specular = light.colour() * arriving *
                                   (object.phongKS() * std::pow(mirrored, object.phongAlpha()));

        // TASK T2.1 begin
        const auto share = [&]() -> double {
            const Vector3 start = P + N * kShadowBias;
            if (const auto found = known.find(Cell::of(start)); found != known.end()) return found->second;
            int arrived = 0;
            for (int i = 0; i < settings().shadowRayCount; ++i) {
                const Vector3 way = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
                const auto hit = scene.findClosestIntersection({start, way.normalised()});
                arrived += !hit || hit->distance > way.magnitude();
            }
            return known[Cell::of(start)] = static_cast<double>(arrived) / settings().shadowRayCount;
        };
        colour += (diffuse + specular) * share();
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const auto [f, a, n, depth] = std::tuple{settings().dofFocalPlane, settings().dofAmount,
                                                 settings().dofRayCount, settings().bounces};
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 meeting{d.x / d.z * f, d.y / d.z * f, f};
        ColourRGB mean;
        for (int k = 1; k <= n; ++k) {
            const double lensX = randomBetween(-a, a);
            const double lensY = randomBetween(-a, a);
            const Vector3 lens{lensX, lensY, 0.0};
            const ColourRGB sample = trace(scene, {lens, (meeting - lens).normalised()}, depth);
            mean += (sample - mean) / k;
        }
        image.set(x, y, mean);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
