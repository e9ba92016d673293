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
        std::minstd_rand engine(1u + static_cast<unsigned>(randomBetween(0.0, 2.0e9)));
        std::uniform_real_distribution<float> side(-1.0f, 1.0f);
        const Vector3 origin = P + N * kShadowBias;
        int blocked = 0, cast = 0;
        while (cast < settings().shadowRayCount) {
            const float a = side(engine), b = side(engine), c = side(engine);
            if (a * a + b * b + c * c > 1.0f) continue;   // outside of the ball: once more
            ++cast;
            const Vector3 way = light.position() + Vector3{a, b, c} * settings().lightSize - origin;
            const auto hit = scene.findClosestIntersection(Ray{origin, way.normalised()});
            if (hit.has_value() && hit->distance <= way.magnitude()) ++blocked;
        }
        colour += (diffuse + specular) * (1.0 - blocked / static_cast<double>(cast));
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
