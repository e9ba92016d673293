// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

ColourRGB withoutFireflies(const ColourRGB& c) {
    return {std::min(c.r, 1.0), std::min(c.g, 1.0), std::min(c.b, 1.0)};
}

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
        const auto sees = [&](const Vector3& goal) {
            const Ray path{P + N * kShadowBias, goal - P - N * kShadowBias};
            const auto hit = scene.findClosestIntersection(path);
            return !(hit && hit->distance < 1.0);  // in lengths of the direction
        };
        double visible = 0.0;
        for (int left = settings().shadowRayCount; left > 0; --left)
            visible += sees(light.position() + settings().lightSize * Vector3::randomInsideUnitSphere());
        visible /= settings().shadowRayCount;
        colour += diffuse * visible + specular * visible;
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
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens = settings().dofAmount * Vector3{randomBetween(-1.0, 1.0), randomBetween(-1.0, 1.0), 0.0};
            sum += withoutFireflies(trace(scene, {lens, (focus - lens).normalised()}, settings().bounces));
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
