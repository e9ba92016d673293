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
        int free = 0;
        for (int k = 0; k < settings().shadowRayCount; k++) {
            Vector3 spot = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            Vector3 way = spot - P;
            auto hit = scene.findClosestIntersection(Ray{P + N * kShadowBias, way.normalised()});
            if (!hit.has_value() || hit->distance >= way.magnitude()) free++;
        }
        double lit = double(free) / settings().shadowRayCount;
        colour += diffuse * lit + specular * lit;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray axis{Vector3{}, Vector3{0, 0, 1}};
        const auto subject = scene.findClosestIntersection(axis);
        const double focalPlane = subject ? subject->location.z : settings().dofFocalPlane;
        const Ray r = camera.castRay(x, y);
        const Vector3 focus = r.evaluateAt(focalPlane / r.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens{randomBetween(-1, 1) * settings().dofAmount, randomBetween(-1, 1) * settings().dofAmount, 0};
            sum += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
