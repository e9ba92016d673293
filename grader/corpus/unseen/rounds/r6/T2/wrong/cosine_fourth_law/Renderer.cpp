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
        // Backwards: from the light to the point. Blocked where something stops the ray early.
        const Vector3 goal = P + N * kShadowBias;
        int n = 0;
        for (int i = 0; i != settings().shadowRayCount; ++i) {
            const Vector3 lamp = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 way = goal - lamp;
            const double length = way.magnitude();
            const auto hit = scene.findClosestIntersection(Ray{lamp, way / length});
            if (!hit || hit->distance >= length) n++;
        }
        colour += (diffuse + specular) * (n * 1.0 / settings().shadowRayCount);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray pin = camera.castRay(x, y);
        const Vector3 focal = pin.evaluateAt(settings().dofFocalPlane / pin.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens{settings().dofAmount * randomBetween(-1, 1), settings().dofAmount * randomBetween(-1, 1), 0};
            const Ray ray{lens, (focal - lens).normalised()};
            const double cos2 = ray.direction.z * ray.direction.z;
            sum += trace(scene, ray, settings().bounces) * (cos2 * cos2);  // irradiance on the film
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
