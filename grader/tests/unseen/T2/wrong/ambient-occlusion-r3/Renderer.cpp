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
    ColourRGB direct;
    double visibility = 0;
    const Vector3 V = (O - P).normalised();
    const Vector3 start = P + N * kShadowBias;
    for (const PointLight& light : scene.pointLights()) {
        const Vector3 L = (light.position() - P).normalised();
        const ColourRGB I = light.illuminationAt((light.position() - P).magnitude());
        // TASK T2.1 begin
        double vis = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 d = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
            const auto h = scene.findClosestIntersection(Ray{start, d.normalised()});
            if (!h || h->distance > d.magnitude()) vis += 1;
        }
        vis /= settings().shadowRayCount;
        visibility += vis / scene.pointLights().size();
        direct += vis * (object.colour() * I * (object.phongKD() * std::max(0.0, N.dot(L))));
        direct += vis * (light.colour() * I * (object.phongKS() * std::pow(std::max(0.0, L.reflectIn(N).dot(V)), object.phongAlpha())));
        // TASK T2.1 end
    }
    if (scene.pointLights().empty()) visibility = 1;
    // ambient occlusion: half of the ambient comes from everywhere
    return direct + object.colour() * scene.ambientLighting() * (0.5 + 0.5 * visibility);
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
