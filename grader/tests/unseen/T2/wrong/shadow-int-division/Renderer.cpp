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
        int numShadowRays = settings().shadowRayCount;
        int numReached = 0;
        for (int i = 0; i < numShadowRays; i++) {
            Vector3 randomPoint = Vector3::randomInsideUnitSphere() * settings().lightSize;
            Vector3 lightPoint = light.position() + randomPoint;
            Vector3 origin = P + N * kShadowBias;
            Vector3 direction = (lightPoint - origin).normalised();
            double lightDistance = (lightPoint - origin).magnitude();
            Ray shadowRay(origin, direction);
            auto hit = scene.findClosestIntersection(shadowRay);
            if (!hit || hit->distance > lightDistance) {
                numReached++;
            }
        }
        double proportion = numReached / numShadowRays;
        colour += (diffuse + specular) * proportion;
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
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 origin{randomBetween(-1, 1) * settings().dofAmount,
                                 randomBetween(-1, 1) * settings().dofAmount, 0};
            sum += trace(scene, Ray{origin, (focal - origin).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
