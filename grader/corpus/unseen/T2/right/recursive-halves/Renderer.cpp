// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

int countArriving(const Scene& scene, const Vector3& start, const Vector3& light, double size, int n) {
    if (n <= 0) return 0;
    if (n > 1)
        return countArriving(scene, start, light, size, n / 2) +
               countArriving(scene, start, light, size, n - n / 2);
    const Vector3 path = light + size * Vector3::randomInsideUnitSphere() - start;
    const auto hit = scene.findClosestIntersection(Ray{start, path.normalised()});
    return hit && hit->distance < path.magnitude() ? 0 : 1;
}

ColourRGB lensSum(const Renderer& renderer, const Scene& scene, const Vector3& focus, int n) {
    if (n > 1)
        return lensSum(renderer, scene, focus, n / 2) + lensSum(renderer, scene, focus, n - n / 2);
    const double a = renderer.settings().dofAmount;
    const double x = randomBetween(-a, a);
    const Vector3 lens{x, randomBetween(-a, a), 0.0};
    return renderer.trace(scene, Ray{lens, (focus - lens).normalised()}, renderer.settings().bounces);
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
        const int n = settings().shadowRayCount;
        colour += (diffuse + specular) *
                  (countArriving(scene, P + N * kShadowBias, light.position(), settings().lightSize, n) /
                   static_cast<double>(n));
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
        const int n = settings().dofRayCount;
        image.set(x, y, lensSum(*this, scene, focus, n) / n);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
