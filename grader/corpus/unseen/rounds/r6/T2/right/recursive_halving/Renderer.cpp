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
        const std::function<int(int)> arrivals = [&](int rays) -> int {
            if (rays <= 0) return 0;
            if (rays > 1) return arrivals(rays / 2) + arrivals(rays - rays / 2);
            const Vector3 start = P + N * kShadowBias;
            const Vector3 way = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere() - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
            return hit && hit->distance < way.magnitude() ? 0 : 1;
        };
        colour += (diffuse + specular) * (arrivals(settings().shadowRayCount) / static_cast<double>(settings().shadowRayCount));
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray pin = camera.castRay(x, y);
        const Vector3 focus = pin.evaluateAt((settings().dofFocalPlane - pin.origin.z) / pin.direction.z);
        const std::function<ColourRGB(int)> gather = [&](int n) -> ColourRGB {
            if (n > 1) return gather(n / 2) + gather(n - n / 2);
            const double A = settings().dofAmount;
            const Vector3 lens = pin.origin + Vector3{A * randomBetween(-1, 1), A * randomBetween(-1, 1), 0};
            return trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
        };
        image.set(x, y, gather(settings().dofRayCount) / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
