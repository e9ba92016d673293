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

ColourRGB phong(const SceneObject& object, const PointLight& light, const Vector3& L,
                const Vector3& N, const Vector3& V, const ColourRGB& I) {
    ColourRGB result = object.colour() * I * (object.phongKD() * std::max(0.0, N.dot(L)));
    const double RdotV = std::max(0.0, L.reflectIn(N).dot(V));
    result += light.colour() * I * (object.phongKS() * std::pow(RdotV, object.phongAlpha()));
    return result;
}

}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 V = (O - P).normalised();
    ColourRGB colour = object.colour() * scene.ambientLighting();

    for (const PointLight& light : scene.pointLights()) {
        // TASK T2.1 begin
        const ColourRGB I = light.illuminationAt((light.position() - P).magnitude());
        ColourRGB sum;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 sample =
                light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const Vector3 L = (sample - P).normalised();
            const auto hit = scene.findClosestIntersection(Ray{P + L * 1e-4, L});
            if (hit && hit->distance < (sample - P).magnitude()) continue;
            sum += phong(object, light, L, N, V, I);
        }
        colour += sum / settings().shadowRayCount;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray pinholeRay = camera.castRay(x, y);
        const Vector3 focalPoint =
            pinholeRay.evaluateAt(settings().dofFocalPlane / pinholeRay.direction.z);

        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 eye{randomBetween(-1.0, 1.0) * settings().dofAmount,
                              randomBetween(-1.0, 1.0) * settings().dofAmount, 0.0};
            sum += trace(scene, Ray{eye, (focalPoint - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
