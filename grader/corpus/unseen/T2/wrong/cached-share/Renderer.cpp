// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace raytracer {
namespace {

struct CachedShare {
    const SceneObject* object = nullptr;
    Vector3 where;
    double share = 0.0;
};

}  // namespace

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
        thread_local std::map<const PointLight*, CachedShare> cache;
        CachedShare& last = cache[&light];
        if (last.object != &object || (last.where - P).magnitude() > 0.05) {
            int arrived = 0;
            for (int i = 0; i < settings().shadowRayCount; ++i) {
                const Vector3 aim = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
                const auto hit = scene.findClosestIntersection(Ray{P + N * kShadowBias, (aim - P).normalised()});
                if (!hit || hit->distance > distance) ++arrived;
            }
            last.share = static_cast<double>(arrived) / settings().shadowRayCount;
            last.where = P;
            last.object = &object;
        }
        colour += (diffuse + specular) * last.share;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray pinhole = camera.castRay(x, y);
        const Plane focalPlane{Vector3{0, 0, settings().dofFocalPlane}, Vector3{0, 0, -1}, Material{}};
        const Vector3 focus = focalPlane.intersectionWith(pinhole)->location;
        ColourRGB average;
        for (int i = 0; i < settings().dofRayCount; i++) {
            Vector3 eye;
            eye.x = randomBetween(-settings().dofAmount, settings().dofAmount);
            eye.y = randomBetween(-settings().dofAmount, settings().dofAmount);
            average += trace(scene, Ray{eye, (focus - eye).normalised()}, settings().bounces) * (1.0 / settings().dofRayCount);
        }
        image.set(x, y, average);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
