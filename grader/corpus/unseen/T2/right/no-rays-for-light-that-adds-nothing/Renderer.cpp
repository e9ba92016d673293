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
        // No light to scale: no need to look for its shadow.
        const ColourRGB unshadowed = diffuse + specular;
        if (unshadowed == ColourRGB{}) continue;

        const Vector3 start = P + N * kShadowBias;
        double visibility = 0.0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 goal = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const auto hit = scene.findClosestIntersection(Ray{start, (goal - start).normalised()});
            const double arrives = hit && hit->distance < (goal - start).magnitude() ? 0.0 : 1.0;
            visibility += (arrives - visibility) / (i + 1);
        }
        colour += unshadowed * visibility;
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
        const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        ColourRGB mean;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens{randomBetween(-settings().dofAmount, settings().dofAmount),
                               randomBetween(-settings().dofAmount, settings().dofAmount), 0};
            const ColourRGB next = trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
            mean += (next - mean) / (i + 1);
        }
        image.set(x, y, mean);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
