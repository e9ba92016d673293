// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
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
        // As soon as something is in the way there is no need to look further.
        int unblocked = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 target = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const Vector3 dir = (target - P).normalised();
            const auto hit = scene.findClosestIntersection({P + N * kShadowBias, dir});
            const bool blocked = hit && hit->distance < (target - P).magnitude();
            if (blocked) break;
            unblocked++;
        }
        const double fraction = 1.0 * unblocked / settings().shadowRayCount;
        colour += diffuse * fraction;
        colour += specular * fraction;
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
