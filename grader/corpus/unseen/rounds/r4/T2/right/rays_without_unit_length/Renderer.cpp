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
        // Directions are not normalised: a distance of 1 is exactly the light
        const Vector3 start = P + N * kShadowBias;
        int seen = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 whole = light.position() - start +
                                  settings().lightSize * Vector3::randomInsideUnitSphere();
            const auto hit = scene.findClosestIntersection(Ray{start, whole});
            if (hit && hit->distance < 1.0) continue;
            ++seen;
        }
        colour += (diffuse + specular) * (seen / static_cast<double>(settings().shadowRayCount));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray p = camera.castRay(x, y);
        const double sx = p.direction.x / p.direction.z;
        const double sy = p.direction.y / p.direction.z;
        const double f = settings().dofFocalPlane;
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double lx = randomBetween(-settings().dofAmount, settings().dofAmount);
            const double ly = randomBetween(-settings().dofAmount, settings().dofAmount);
            // from the lens to the focal plane in one step
            sum += trace(scene, Ray{{lx, ly, 0}, {sx * f - lx, sy * f - ly, f}}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
