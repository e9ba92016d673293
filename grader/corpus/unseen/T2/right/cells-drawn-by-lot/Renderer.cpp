// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <random>
#include <vector>

namespace raytracer {

namespace {
struct Lot {
    std::mt19937_64 engine;
    explicit Lot(std::uint64_t seed) : engine(seed) {}
    double unit() { return std::uniform_real_distribution<>{0.0, 1.0}(engine); }
    double signedUnit() { return 2 * unit() - 1; }
};
}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 toViewer = (O - P).normalised();
    ColourRGB colour = object.colour() * scene.ambientLighting();

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
        Lot lot{static_cast<std::uint64_t>(randomBetween(0, 9e15))};
        const Vector3 start = P + N * kShadowBias;
        int seen = 0;
        for (int i = 0; i != settings().shadowRayCount; ++i) {
            double a, b, q;
            do {
                a = lot.signedUnit();
                b = lot.signedUnit();
                q = a * a + b * b;
            } while (q >= 1);
            const double root = 2 * std::sqrt(1 - q);
            const double radius = settings().lightSize * std::max({lot.unit(), lot.unit(), lot.unit()});
            const Vector3 goal = light.position() + radius * Vector3{a * root, b * root, 1 - 2 * q};
            const double far = (goal - start).magnitude();
            const auto stop = scene.findClosestIntersection(Ray{start, (goal - start) / far});
            if (stop && stop->distance <= far) continue;
            ++seen;
        }
        const double part = seen / static_cast<double>(settings().shadowRayCount);
        colour += part * diffuse;
        colour += part * specular;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const int n = settings().dofRayCount;
        const int side = static_cast<int>(std::ceil(std::sqrt(n)));
        Lot lot{static_cast<std::uint64_t>(randomBetween(0, 9e15))};
        std::vector<int> all(side * side), mine;
        std::iota(all.begin(), all.end(), 0);
        std::sample(all.begin(), all.end(), std::back_inserter(mine), n, lot.engine);
        const Ray old = camera.castRay(x, y);
        const Vector3 focus = old.direction * (settings().dofFocalPlane / old.direction.z);
        ColourRGB sum;
        for (int cell : mine) {
            const Vector3 from{settings().dofAmount * (2 * (cell % side + lot.unit()) / side - 1),
                               settings().dofAmount * (2 * (cell / side + lot.unit()) / side - 1), 0};
            sum += trace(scene, Ray{from, (focus - from).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / n);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
