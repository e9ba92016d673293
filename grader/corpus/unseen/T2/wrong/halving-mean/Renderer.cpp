// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
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
        double visible = 0.0;
        for (int k = 0; k < settings().shadowRayCount; k++) {
            Vector3 lightPoint = Vector3::randomInsideUnitSphere();
            lightPoint *= settings().lightSize;
            lightPoint += light.position();
            const Vector3 dir = (lightPoint - P).normalised();
            const std::optional<RaycastHit> blocker = scene.findClosestIntersection(Ray{P + N * kShadowBias, dir});
            if (blocker && blocker->distance < distance) continue;
            visible += 1.0 / settings().shadowRayCount;
        }
        colour += diffuse * visible + specular * visible;
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
        const auto shoot = [&] {
            const double u = randomBetween(-settings().dofAmount, settings().dofAmount);
            const double v = randomBetween(-settings().dofAmount, settings().dofAmount);
            const Vector3 lens{u, v, 0.0};
            return trace(scene, Ray{lens, (focal - lens).normalised()}, settings().bounces);
        };
        ColourRGB average = shoot();
        for (int i = 1; i < settings().dofRayCount; ++i)
            average = (average + shoot()) / 2.0;
        image.set(x, y, average);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
