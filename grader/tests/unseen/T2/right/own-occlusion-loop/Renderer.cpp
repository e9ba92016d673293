#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <cmath>
#include <ranges>

namespace raytracer {
namespace {
// Any hit before the lamp will do: no need to find the closest.
bool free(const Scene& scene, const Vector3& from, const Vector3& to) {
    const Vector3 way = to - from;
    const double length = way.magnitude();
    const Ray ray{from, way / length};
    return std::ranges::none_of(scene.objects(), [&](const auto& object) {
        const auto hit = object->intersectionWith(ray);
        return hit && hit->distance < length;
    });
}

int countFree(const Scene& scene, const Vector3& from, const PointLight& light, double size,
              int left) {
    if (left == 0) return 0;
    const bool seen =
        free(scene, from, light.position() + Vector3::randomInsideUnitSphere() * size);
    return (seen ? 1 : 0) + countFree(scene, from, light, size, left - 1);
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
        const double mirrored = std::max(0.0, toLight.reflectIn(N).dot(toViewer));
        if (facing <= 0.0 && mirrored <= 0.0) continue;  // nothing to shadow
        const ColourRGB diffuse = object.colour() * arriving * (object.phongKD() * facing);
        const ColourRGB specular = light.colour() * arriving *
                                   (object.phongKS() * std::pow(mirrored, object.phongAlpha()));
        const int n = settings().shadowRayCount;
        colour += (diffuse + specular) *
                  (countFree(scene, P + N * kShadowBias, light, settings().lightSize, n) /
                   static_cast<double>(n));
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray eye = camera.castRay(x, y);
        const Plane focalPlane{{0, 0, settings().dofFocalPlane}, {0, 0, -1}, Material{}};
        const Vector3 focus = eye.evaluateAt(focalPlane.distanceAlong(eye));
        ColourRGB sum;
        int done = 0;
        while (done != settings().dofRayCount) {
            Vector3 lens;
            lens.x = settings().dofAmount * randomBetween(-1, 1);
            lens.y = settings().dofAmount * randomBetween(-1, 1);
            sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
            ++done;
        }
        sum /= done;
        image.set(x, y, sum);
    });
    return image;
}
}  // namespace raytracer
