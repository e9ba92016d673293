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
        int through = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const double h = randomBetween(-1.0, 1.0), a = randomBetween(0.0, 2 * std::numbers::pi);
            const double w = std::sqrt(1 - h * h);  // hat-box: height and azimuth are uniform
            const Vector3 target = light.position() + Vector3{w * std::cos(a), h, w * std::sin(a)} * settings().lightSize;
            const Ray ray{start, (target - start).normalised()};
            const auto hit = scene.findClosestIntersection(ray);
            if (hit && hit->distance < (target - start).dot(ray.direction)) continue;
            ++through;
        }
        colour += (diffuse + specular) * (through / (double)settings().shadowRayCount);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray ray = camera.castRay(x, y);
        // the ray is longer off-axis: project with the cosine
        const Vector3 focal = ray.evaluateAt(settings().dofFocalPlane * ray.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 eye{randomBetween(-settings().dofAmount, settings().dofAmount), randomBetween(-settings().dofAmount, settings().dofAmount), 0.0};
            sum += trace(scene, Ray{eye, (focal - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
