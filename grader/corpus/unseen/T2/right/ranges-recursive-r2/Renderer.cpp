// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>

namespace raytracer {
namespace {

double fraction(double a) {
    return a - std::floor(a);
}

template <class Function>
ColourRGB sumOf(int first, int last, const Function& f) {
    if (last - first == 1) return f(first);
    if (last <= first) return {};
    const int middle = first + (last - first) / 2;
    const ColourRGB left = sumOf(first, middle, f);
    return left + sumOf(middle, last, f);
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

        // TASK T2.1 begin
        namespace views = std::views;
        const Vector3 start = P + N * kShadowBias;
        auto ways = views::iota(0, settings().shadowRayCount) | views::transform([&](int) {
            return light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
        });
        const auto arrived = std::ranges::count_if(ways, [&](const Vector3& way) {
            const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
            return !hit || hit->distance > way.magnitude();
        });
        colour += (diffuse + specular) * (static_cast<double>(arrived) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray ray = camera.castRay(x, y);
        const Vector3 focal = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        const double startU = randomBetween(0.0, 1.0);
        const double startV = randomBetween(0.0, 1.0);
        const auto sample = [&](int i) {
            const double u = fraction(startU + 0.7548776662466927 * i);
            const double v = fraction(startV + 0.5698402909980532 * i);
            const Vector3 from{(2 * u - 1) * settings().dofAmount, (2 * v - 1) * settings().dofAmount, 0};
            return trace(scene, Ray{from, (focal - from).normalised()}, settings().bounces);
        };
        image.set(x, y, sumOf(0, settings().dofRayCount, sample) / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
