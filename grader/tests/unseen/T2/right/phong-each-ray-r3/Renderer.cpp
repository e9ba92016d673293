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
    // TASK T2.1 begin
    for (const PointLight& light : scene.pointLights()) {
        ColourRGB sum;
        const Vector3 start = P + N * kShadowBias;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 s = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 L = (s - P).normalised();
            const auto block = scene.findClosestIntersection(Ray{start, (s - start).normalised()});
            if (block && block->distance < (s - start).magnitude()) continue;
            const ColourRGB I = light.illuminationAt((s - P).magnitude());
            sum += object.colour() * I * (object.phongKD() * std::max(0.0, N.dot(L)));
            const double rv = std::max(0.0, L.reflectIn(N).dot(toViewer));
            sum += light.colour() * I * (object.phongKS() * std::pow(rv, object.phongAlpha()));
        }
        colour += sum / settings().shadowRayCount;
    }
    // TASK T2.1 end
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray r = camera.castRay(x, y);
        const Vector3 focus = r.direction * (settings().dofFocalPlane / r.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; i++) {
            double ax = settings().dofAmount * randomBetween(-1, 1);
            double ay = settings().dofAmount * randomBetween(-1, 1);
            Vector3 eye{ax, ay, 0};
            sum += trace(scene, Ray{eye, (focus - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
