// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <functional>
#include <numeric>
#include <ranges>
#include <type_traits>

namespace raytracer {
namespace {

/// Mean of n results of `draw`.
template <typename Draw>
auto meanOf(int n, Draw draw) {
    using Value = std::invoke_result_t<Draw>;
    auto values = std::views::iota(0, n) | std::views::transform([&](int) { return draw(); }) | std::views::common;
    return std::accumulate(values.begin(), values.end(), Value{}) / n;
}

constexpr auto alongTo = [](const Vector3& from, const Vector3& to) { return Ray{from, (to - from).normalised()}; };

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
        const Vector3 from = P + N * kShadowBias;
        const double share = meanOf(settings().shadowRayCount, [&] {
            const Vector3 to = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const auto hit = scene.findClosestIntersection(alongTo(from, to));
            return hit.has_value() && hit->distance < (to - from).magnitude() ? 0.0 : 1.0;
        });
        colour += share * (diffuse + specular);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const auto axis = camera.castRay(x, y);
        const auto focus = axis.evaluateAt(settings().dofFocalPlane / axis.direction.z);
        const auto offset = [this] { return settings().dofAmount * randomBetween(-1.0, 1.0); };
        image.set(x, y, meanOf(settings().dofRayCount, [&] {
                      return trace(scene, alongTo({offset(), offset(), 0.0}, focus), settings().bounces);
                  }));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
