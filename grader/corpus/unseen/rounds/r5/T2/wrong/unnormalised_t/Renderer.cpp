// No square roots: directions keep their length.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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

        // TASK T2.1 begin
        const Vector3 start = P + N * kShadowBias;
        const auto arrives = [&](const Vector3& target) {
            const Vector3 way = target - start;
            const std::optional<RaycastHit> hit = scene.findClosestIntersection(Ray{start, way});
            return !hit || hit->distance > way.magnitude();
        };
        int count = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i)
            count += arrives(light.position() + settings().lightSize * Vector3::randomInsideUnitSphere()) ? 1 : 0;
        colour += (diffuse + specular) * (count / double(settings().shadowRayCount));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 F = d * (settings().dofFocalPlane / d.z);
        const int n = settings().dofRayCount;
        ColourRGB mean;
        for (int i = 0; i < n; ++i) {
            Vector3 lens;
            lens.x = settings().dofAmount * randomBetween(-1.0, 1.0);
            lens.y = settings().dofAmount * randomBetween(-1.0, 1.0);
            mean += trace(scene, {lens, (F - lens).normalised()}, settings().bounces) * (1.0 / n);
        }
        image.set(x, y, mean);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
