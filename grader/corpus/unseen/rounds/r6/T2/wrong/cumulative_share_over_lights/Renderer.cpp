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

    int arrived = 0;
    int cast = 0;
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
        for (int i = 0; i < settings().shadowRayCount; ++i, ++cast) {
            const Vector3 way = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
            if (!hit || hit->distance > way.magnitude()) ++arrived;
        }
        colour += (diffuse + specular) * (static_cast<double>(arrived) / cast);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const int n = settings().dofRayCount;
        std::vector<int> column(n);
        std::iota(column.begin(), column.end(), 0);
        for (int i = n - 1; i > 0; --i)  // Fisher and Yates
            std::swap(column[i], column[static_cast<int>(randomBetween(0.0, i + 1.0))]);
        const Ray axis = camera.castRay(x, y);
        const Vector3 F = axis.direction * (settings().dofFocalPlane / axis.direction.z);
        ColourRGB sum;
        for (int i = 0; i < n; ++i) {
            const double s = (i + randomBetween(0.0, 1.0)) / n, t = (column[i] + randomBetween(0.0, 1.0)) / n;
            const Vector3 E{(2 * s - 1) * settings().dofAmount, (2 * t - 1) * settings().dofAmount, 0};
            sum += trace(scene, Ray{E, (F - E).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / n);
    });
    return image;
}

}  // namespace raytracer
