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
    const double R = settings().lightSize;
    for (const PointLight& light : scene.pointLights()) {
        const Vector3 toLight = (light.position() - P).normalised();
        // the light is a ball now, it starts R earlier
        const double distance = std::max((light.position() - P).magnitude() - R, 0.1);
        const ColourRGB arriving = light.illuminationAt(distance);
        const ColourRGB diffuse = object.colour() * arriving * (object.phongKD() * std::max(0.0, N.dot(toLight)));
        const double mirrored = std::max(0.0, toLight.reflectIn(N).dot(toViewer));
        const ColourRGB specular = light.colour() * arriving * (object.phongKS() * std::pow(mirrored, object.phongAlpha()));
        // TASK T2.1 begin
        int reached = 0;
        const Vector3 start = P + N * kShadowBias;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            Vector3 target = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            Vector3 d = target - start;
            auto hit = scene.findClosestIntersection(Ray{start, d.normalised()});
            if (!hit || hit->distance > d.magnitude()) reached++;
        }
        colour += (diffuse + specular) * ((double)reached / settings().shadowRayCount);
        // TASK T2.1 end
    }
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
