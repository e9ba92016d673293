#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <cmath>

namespace raytracer {
// Every random point comes with its mirror image: the mean of the samples is exact.
ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 toViewer = (O - P).normalised();
    ColourRGB colour = object.colour() * scene.ambientLighting();
    for (const PointLight& light : scene.pointLights()) {
        const double distance = (light.position() - P).magnitude();
        const Vector3 toLight = (light.position() - P).normalised();
        const ColourRGB arriving = light.illuminationAt(distance);
        const ColourRGB full =
            object.colour() * arriving * (object.phongKD() * std::max(0.0, N.dot(toLight))) +
            light.colour() * arriving *
                (object.phongKS() *
                 std::pow(std::max(0.0, toLight.reflectIn(N).dot(toViewer)), object.phongAlpha()));
        const Vector3 from = P + N * kShadowBias;
        const auto sees = [&](const Vector3& to) {
            const auto hit = scene.findClosestIntersection({from, (to - from).normalised()});
            return !hit || hit->distance > (to - from).magnitude();
        };
        const int pairs = (settings().shadowRayCount + 1) / 2;
        int open = 0;
        for (int i = 0; i < pairs; ++i) {
            const Vector3 offset = Vector3::randomInsideUnitSphere() * settings().lightSize;
            open += sees(light.position() + offset);
            open += sees(light.position() - offset);
        }
        colour += full * (open / (2.0 * pairs));
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray ray = camera.castRay(x, y);
        const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        const auto through = [&](const Vector3& lens) {
            return trace(scene, {lens, focus - lens}, settings().bounces);  // any length works
        };
        const int pairs = (settings().dofRayCount + 1) / 2;
        ColourRGB sum;
        for (int i = 0; i < pairs; ++i) {
            const double a = settings().dofAmount * randomBetween(-1, 1);
            const double b = settings().dofAmount * randomBetween(-1, 1);
            sum += through({a, b, 0});
            sum += through({-a, -b, 0});
        }
        image.set(x, y, sum / (2 * pairs));
    });
    return image;
}
}  // namespace raytracer
