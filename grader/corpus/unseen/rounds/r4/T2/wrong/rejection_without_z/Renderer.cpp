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
        double lit = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            double rx = randomBetween(-1, 1);
            double ry = randomBetween(-1, 1);
            double rz = randomBetween(-1, 1);
            while (rx * rx + ry * ry > 1) {
                rx = randomBetween(-1, 1);
                ry = randomBetween(-1, 1);
            }
            Vector3 target = light.position() + Vector3(rx, ry, rz) * settings().lightSize;
            Vector3 start = P + kShadowBias * N;
            double length = (target - start).magnitude();
            auto h = scene.findClosestIntersection(Ray(start, (target - start) / length));
            if (!h || h->distance > length) lit += 1.0 / settings().shadowRayCount;
        }
        colour += (diffuse + specular) * lit;
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
        double t = settings().dofFocalPlane / ray.direction.z;
        Vector3 focus = ray.evaluateAt(t);
        ColourRGB total(0, 0, 0);
        for (int i = 0; i < settings().dofRayCount; i++) {
            double dx = settings().dofAmount * randomBetween(-1, 1);
            double dy = settings().dofAmount * randomBetween(-1, 1);
            Vector3 origin(dx, dy, 0);
            Ray newRay(origin, (focus - origin).normalised());
            total += trace(scene, newRay, settings().bounces);
        }
        total /= settings().dofRayCount;
        image.set(x, y, total);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
