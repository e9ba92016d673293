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
    // TASK T2.2 begin
    for (int pass = 0; pass < settings().dofRayCount; ++pass) {
        forEachPixel(image, [&](int x, int y) {
            const Ray ray = camera.castRay(x, y);
            const Vector3 focal = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
            const double dx = settings().dofAmount * randomBetween(-1.0, 1.0);
            const double dy = settings().dofAmount * randomBetween(-1.0, 1.0);
            const Vector3 from = ray.origin + Vector3{dx, dy, 0.0};
            const Ray lensRay{from, (focal - from).normalised()};
            const ColourRGB colour = trace(scene, lensRay, settings().bounces);
            image.set(x, y, image.at(x, y) + colour / settings().dofRayCount);
        });
    }
    // TASK T2.2 end
    return image;
}

}  // namespace raytracer
