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
        const Vector3 start = P + N * kShadowBias;
        int reached = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 target = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Ray ray{start, target - start};
            const auto hit = scene.findClosestIntersection(ray);
            if (!hit || hit->distance > distance) ++reached;
        }
        colour += (diffuse + specular) * (double(reached) / settings().shadowRayCount);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray pin = camera.castRay(x, y);
        const double t = settings().dofFocalPlane / pin.direction.z;
        ColourRGB total;
        double p = 0, q = 0;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            if (i % 4 == 0) { p = randomBetween(-1, 1) * settings().dofAmount; q = randomBetween(-1, 1) * settings().dofAmount; }
            else { const double old = p; p = -q; q = old; }   // a quarter turn: four antithetic points
            const Vector3 from{p, q, 0};
            total += trace(scene, Ray{from, (pin.direction * t - from).normalised()}, settings().bounces);
        }
        image.set(x, y, total / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
