// I read "a square aperture of dimension DOF_AMOUNT" as the length of its side.
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
        int shadowed = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            Vector3 randomOffset = Vector3::randomInsideUnitSphere();
            randomOffset *= settings().lightSize;
            Vector3 lightPoint = light.position() + randomOffset;
            Vector3 origin = P + N * kShadowBias;
            Ray shadowRay(origin, (lightPoint - origin).normalised());
            auto hit = scene.findClosestIntersection(shadowRay);
            if (hit.has_value()) {
                if (hit->distance < (lightPoint - origin).magnitude()) {
                    shadowed++;
                }
            }
        }
        double shadowProportion = shadowed * 1.0 / settings().shadowRayCount;
        colour += (diffuse + specular) * (1 - shadowProportion);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        Ray ray = camera.castRay(x, y);
        double scale = settings().dofFocalPlane / ray.direction.z;
        Vector3 intersection = ray.direction * scale;

        ColourRGB averaged(0, 0, 0);
        for (int i = 0; i < settings().dofRayCount; i++) {
            double xOffset = (randomBetween(0, 1) - 0.5) * settings().dofAmount;
            double yOffset = (randomBetween(0, 1) - 0.5) * settings().dofAmount;
            Vector3 newOrigin(xOffset, yOffset, 0);
            Vector3 newDirection = (intersection - newOrigin).normalised();
            averaged += trace(scene, Ray(newOrigin, newDirection), settings().bounces);
        }
        averaged *= 1.0 / settings().dofRayCount;
        image.set(x, y, averaged);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
