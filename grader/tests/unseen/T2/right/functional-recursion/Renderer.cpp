// No loop in sight.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <ranges>

namespace raytracer {
namespace {

// Halves the work until one sample is left: the recursion is only log2(n) deep.
template <class Value>
Value total(int n, const std::function<Value()>& sample) {
    if (n <= 0) return Value{};
    if (n == 1) return sample();
    const Value first = total<Value>(n / 2, sample);
    return first + total<Value>(n - n / 2, sample);
}

template <class Value>
Value mean(int n, const std::function<Value()>& sample) {
    return total<Value>(n, sample) / n;
}

}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 toViewer = (O - P).normalised();

    const auto visibleShare = [&](const PointLight& light) {
        return mean<double>(settings().shadowRayCount, [&] {
            const Vector3 start = P + N * kShadowBias;
            const Vector3 way =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection({start, way.normalised()});
            return hit && hit->distance < way.magnitude() ? 0.0 : 1.0;
        });
    };

    const auto phong = [&](const PointLight& light) {
        const Vector3 path = light.position() - P;
        const Vector3 toLight = path.normalised();
        const ColourRGB arriving = light.illuminationAt(path.magnitude());
        const double facing = std::max(0.0, N.dot(toLight));
        const double mirrored = std::max(0.0, toLight.reflectIn(N).dot(toViewer));
        return object.colour() * arriving * (object.phongKD() * facing) +
               light.colour() * arriving *
                   (object.phongKS() * std::pow(mirrored, object.phongAlpha()));
    };

    // TASK T2.1 begin
    return std::transform_reduce(
        scene.pointLights().begin(), scene.pointLights().end(),
        object.colour() * scene.ambientLighting(), std::plus<>{},
        [&](const PointLight& light) { return phong(light) * visibleShare(light); });
    // TASK T2.1 end
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 focus = d / d.z * settings().dofFocalPlane;
        image.set(x, y, mean<ColourRGB>(settings().dofRayCount, [&] {
                      const double a = settings().dofAmount;
                      const Vector3 lens{randomBetween(-a, a), randomBetween(-a, a), 0.0};
                      return trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
                  }));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
