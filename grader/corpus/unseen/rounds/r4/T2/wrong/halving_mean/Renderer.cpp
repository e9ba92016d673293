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
        int hits = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            Vector3 target = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            Vector3 start = P + N * kShadowBias;
            double d = (target - start).magnitude();
            Ray r{start, (target - start).normalised()};
            auto hit = scene.findClosestIntersection(r);
            if (hit.has_value() && hit->distance < d) {
                hits++;
            }
        }
        double lit = 1.0 - (double)hits / settings().shadowRayCount;
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
        Ray ray = camera.castRay(x, y);
        Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        ColourRGB colour;
        for (int i = 0; i < settings().dofRayCount; i++) {
            Vector3 lens(randomBetween(-1, 1) * settings().dofAmount,
                         randomBetween(-1, 1) * settings().dofAmount, 0);
            ColourRGB next = trace(scene, Ray(lens, (focus - lens).normalised()), settings().bounces);
            if (i == 0) {
                colour = next;
            } else {
                // average of what we have and the new one
                colour = (colour + next) / 2;
            }
        }
        image.set(x, y, colour);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
