// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
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
        ColourRGB sum;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 spot = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Ray ray{P + N * kShadowBias, spot - P - N * kShadowBias};
            if (const auto hit = scene.findClosestIntersection(ray); hit && hit->distance < 1.0) continue;
            const Vector3 L = (spot - P).normalised();
            const ColourRGB I = light.illuminationAt((spot - P).magnitude());
            sum += object.colour() * I * (object.phongKD() * std::max(0.0, N.dot(L)));
            sum += light.colour() * I * (object.phongKS() * std::pow(std::max(0.0, L.reflectIn(N).dot(toViewer)), object.phongAlpha()));
        }
        colour += sum / settings().shadowRayCount;
        (void)diffuse;
        (void)specular;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray pin = camera.castRay(x, y);
        const Vector3 focus = pin.direction / pin.direction.z * settings().dofFocalPlane;
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 o = settings().dofAmount * Vector3{randomBetween(-1, 1), randomBetween(-1, 1), 0};
            sum += trace(scene, {o, focus - o}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
