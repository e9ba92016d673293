// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
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
        const Vector3 start = P + N * kShadowBias;
        int clear = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Ray whole{start, light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start};
            const auto hit = scene.findClosestIntersection(whole);
            if (!hit || hit->distance > 1.0) ++clear;  // the direction is the whole way: 1 is the light
        }
        colour += (diffuse + specular) * (double(clear) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 focus = d * (settings().dofFocalPlane / d.z);
        const double a = settings().dofAmount;
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens{a * randomBetween(-1.0, 1.0), a * randomBetween(-1.0, 1.0), 0.0};
            sum += trace(scene, Ray{lens, focus - lens}, settings().bounces);  // rays of any length work
        }
        sum /= settings().dofRayCount;
        image.set(x, y, sum);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
