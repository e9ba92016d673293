// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

/// The least square number of cells that gives at least n rays.
int cellsPerSide(int n) {
    int side = 1;
    while (side * side < n) ++side;
    return side;
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
        ColourRGB direct;
        for (int s = 0; s < settings().shadowRayCount; ++s) {
            const Vector3 from = P + N * kShadowBias;
            const Vector3 to = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const double far = (to - from).magnitude();
            const std::optional<RaycastHit> hit = scene.findClosestIntersection(Ray{from, (to - from) / far});
            const bool lit = !hit.has_value() || hit->distance > far;
            direct += (lit ? 1.0 : 0.0) * (diffuse + specular);
        }
        colour += direct / static_cast<double>(settings().shadowRayCount);
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
        const Vector3 focus = pinhole.direction / pinhole.direction.z * settings().dofFocalPlane;
        // The aperture is a square whose SIDE is dofAmount, cut into side x side cells with one
        // random point in each; rounded up, never fewer rays than asked for.
        const int side = cellsPerSide(settings().dofRayCount);
        const double cell = settings().dofAmount / side;
        ColourRGB sum;
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i) {
                const Vector3 lens{-settings().dofAmount / 2.0 + (i + randomBetween(0.0, 1.0)) * cell,
                                   -settings().dofAmount / 2.0 + (j + randomBetween(0.0, 1.0)) * cell, 0.0};
                sum += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
            }
        }
        image.set(x, y, sum / (side * side));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
