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
        // Radii uniform in [0, R), so each sample stands for a shell of volume ~ r^2: a
        // self-normalised weighted mean, sum(w v) / sum(w).
        const Vector3 start = P + N * kShadowBias;
        double weightSeen = 0.0, weightAll = 0.0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            Vector3 direction;
            do direction = Vector3::randomInsideUnitSphere(); while (direction.dot(direction) < 1e-6);
            const double r = randomBetween(0.05, 1.0);
            const Vector3 target = light.position() + direction.normalised() * (r * settings().lightSize);
            const Vector3 way = target - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
            const double w = r * r;
            weightAll += w;
            if (!hit || hit->distance > way.magnitude()) weightSeen += w;
        }
        colour += (diffuse + specular) * (weightSeen / weightAll);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        std::mt19937 rng(static_cast<std::uint32_t>(randomBetween(0.0, 4294967295.0)));
        std::uniform_real_distribution<double> aperture(-settings().dofAmount / 2, settings().dofAmount / 2);
        const Vector3 dir = camera.castRay(x, y).direction;
        const Vector3 focal = dir * (settings().dofFocalPlane / dir.z);
        double r = 0, g = 0, b = 0;
        for (int i = settings().dofRayCount; i-- > 0;) {
            const double ax = aperture(rng);
            const double ay = aperture(rng);
            const ColourRGB c = trace(scene, Ray{{ax, ay, 0}, (focal - Vector3{ax, ay, 0}).normalised()}, settings().bounces);
            r += c.r; g += c.g; b += c.b;
        }
        const double n = settings().dofRayCount;
        image.set(x, y, {r / n, g / n, b / n});
    });
    return image;
}

}  // namespace raytracer
