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
        const Ray straight = camera.castRay(x, y);
        const Vector3 aim = straight.direction * (settings().dofFocalPlane / straight.direction.z);
        ColourRGB total{0.0};
        for (int k = 0; k < settings().dofRayCount; k++) {
            Vector3 eye(settings().dofAmount * randomBetween(-1, 1),
                        settings().dofAmount * randomBetween(-1, 1), 0);
            const ColourRGB c = trace(scene, Ray(eye, (aim - eye).normalised()), settings().bounces);
            total.r += int(std::min(c.r, 1.0) * 255) / 255.0;
            total.g += int(std::min(c.g, 1.0) * 255) / 255.0;
            total.b += int(std::min(c.b, 1.0) * 255) / 255.0;
        }
        image.set(x, y, total * (1.0 / settings().dofRayCount));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
