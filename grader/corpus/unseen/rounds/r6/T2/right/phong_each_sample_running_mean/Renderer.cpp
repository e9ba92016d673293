// Option 2, tasks T2.1 and T2.2.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <future>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <ranges>
#include <utility>
#include <vector>

namespace raytracer {

/// Every sample is a little light of its own: own direction, own distance, own highlight.
ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 V = (O - P).normalised();
    const Vector3 start = P + N * kShadowBias;
    ColourRGB total = object.colour() * scene.ambientLighting();
    for (const PointLight& light : scene.pointLights()) {
        ColourRGB sum;
        for (int k = 0; k < settings().shadowRayCount; ++k) {
            const Vector3 Q = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 D = Q - start;
            const std::optional<RaycastHit> hit = scene.findClosestIntersection({start, D.normalised()});
            if (hit && hit->distance < D.magnitude()) continue;
            const Vector3 L = (Q - P).normalised();
            const ColourRGB I = light.illuminationAt((Q - P).magnitude());
            const double cosine = std::max(0.0, N.dot(L));
            const double lobe = std::pow(std::max(0.0, L.reflectIn(N).dot(V)), object.phongAlpha());
            sum += object.colour() * I * (object.phongKD() * cosine) + light.colour() * I * (object.phongKS() * lobe);
        }
        total += sum / settings().shadowRayCount;
    }
    return total;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Vector3 c = camera.castRay(x, y).direction;
        const double z = settings().dofFocalPlane;
        const Vector3 target{z * c.x / c.z, z * c.y / c.z, z};
        ColourRGB mean;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            Vector3 o;
            o.x = settings().dofAmount * randomBetween(-1.0, 1.0);
            o.y = settings().dofAmount * randomBetween(-1.0, 1.0);
            const ColourRGB sample = trace(scene, Ray{o, (target - o).normalised()}, settings().bounces);
            mean += (sample - mean) / (i + 1.0);
        }
        image.set(x, y, mean);
    });
    return image;
}

}  // namespace raytracer
