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
namespace {

double radicalInverse(int base, int i) {
    double result = 0, digit = 1.0 / base;
    for (; i > 0; i /= base, digit /= base) result += digit * (i % base);
    return result;
}

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
        const Vector3 start = P + N * kShadowBias;
        Vector3 offset;
        int reached = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            offset = i % 2 == 0 ? Vector3::randomInsideUnitSphere() * settings().lightSize : -offset;
            const Vector3 way = light.position() + offset - start;
            const auto hit = scene.findClosestIntersection({start, way.normalised()});
            reached += hit && hit->distance < way.magnitude() ? 0 : 1;
        }
        colour += (diffuse + specular) * (double(reached) / settings().shadowRayCount);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    // Halton points, bases 2 and 3, the same for every pixel: no noise between neighbours
    std::vector<Vector3> lensPoints;
    for (int i = 1; i <= std::max(64, settings().dofRayCount); ++i)
        lensPoints.push_back(Vector3{2 * radicalInverse(2, i) - 1, 2 * radicalInverse(3, i) - 1, 0} * settings().dofAmount);
    forEachPixel(image, [&](int x, int y) {
        const Ray pin = camera.castRay(x, y);
        const Vector3 focal = pin.evaluateAt(settings().dofFocalPlane / pin.direction.z);
        ColourRGB sum;
        for (const Vector3& lens : lensPoints)
            sum += trace(scene, Ray{lens, (focal - lens).normalised()}, settings().bounces);
        image.set(x, y, sum / static_cast<double>(lensPoints.size()));
    });
    return image;
}

}  // namespace raytracer
