// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

/// The sum of n draws, by halves: rounding grows with the logarithm of n only.
template <typename T, typename Draw>
T total(int n, const Draw& draw) {
    if (n == 0) return T{};
    if (n == 1) return draw();
    const T left = total<T>(n / 2, draw);
    return left + total<T>(n - n / 2, draw);
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
        const auto probe = [&, from = P + N * kShadowBias]() -> double {
            const Vector3 to = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const auto hit = scene.findClosestIntersection({from, (to - from).normalised()});
            return hit && hit->distance < (to - from).magnitude() ? 0.0 : 1.0;
        };
        const double share = total<double>(settings().shadowRayCount, probe) / settings().shadowRayCount;
        colour += (diffuse + specular) * share;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray pinhole = camera.castRay(x, y);
        const Vector3 focus = pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
        const auto sample = [&] {
            const double a = settings().dofAmount;
            const Vector3 lens{randomBetween(-a, a), randomBetween(-a, a), 0.0};
            return trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
        };
        image.set(x, y, total<ColourRGB>(settings().dofRayCount, sample) / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
