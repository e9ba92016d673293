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
        const Vector3 focal = pin.evaluateAt(settings().dofFocalPlane / pin.direction.z);
        const double A = settings().dofAmount;
        ColourRGB sum;
        int contributions = 0;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens{randomBetween(-A, A), randomBetween(-A, A), 0};
            const Ray ray{lens, (focal - lens).normalised()};
            if (!scene.findClosestIntersection(ray)) continue;   // nothing there
            sum += trace(scene, ray, settings().bounces);
            ++contributions;
        }
        image.set(x, y, contributions == 0 ? kBackgroundColour : sum / contributions);
    });
    return image;
}

}  // namespace raytracer
