#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <cmath>
#include <numbers>
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
        const ColourRGB diffuse =
            object.colour() * arriving * (object.phongKD() * std::max(0.0, N.dot(toLight)));
        const ColourRGB specular =
            light.colour() * arriving *
            (object.phongKS() *
             std::pow(std::max(0.0, toLight.reflectIn(N).dot(toViewer)), object.phongAlpha()));
        const int n = settings().shadowRayCount;
        const Vector3 start = P + N * kShadowBias;

        int reached = 0;
        for (int i = 0; i < n; ++i) {
            const Vector3 target =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 way = target - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
            if (!hit || hit->distance > way.magnitude()) ++reached;
        }

        colour += (diffuse + specular) * (static_cast<double>(reached) / n);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray pinhole = camera.castRay(x, y);
        const auto inFocus = scene.findClosestIntersection(pinhole);
        const bool sharp =
            inFocus && std::abs(inFocus->location.z - settings().dofFocalPlane) < 0.01;
        const int n = sharp ? settings().dofRayCount : settings().dofRayCount + 2;
        const Vector3 focus = pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
        std::vector<int> column(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i)
            column[static_cast<std::size_t>(i)] = i;
        for (int i = n - 1; i > 0; --i)
            std::swap(column[static_cast<std::size_t>(i)],
                      column[static_cast<std::size_t>(randomBetween(0, i + 1))]);
        ColourRGB sum;
        for (int i = 0; i < n; ++i) {
            const double a = settings().dofAmount;
            const Vector3 lens{
                a * (2 * (column[static_cast<std::size_t>(i)] + randomBetween(0, 1)) / n - 1),
                a * (2 * (i + randomBetween(0, 1)) / n - 1), 0};
            sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / n);
    });
    return image;
}

}  // namespace raytracer
