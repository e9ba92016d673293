// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

/// Shirley and Chiu's concentric map from the square.
Vector3 sampleAperture() {
    const double a = randomBetween(-1.0, 1.0);
    const double b = randomBetween(-1.0, 1.0);
    if (a == 0.0 && b == 0.0) return {};
    double r = 0.0, phi = 0.0;
    if (std::abs(a) > std::abs(b)) {
        r = a;
        phi = std::numbers::pi / 4.0 * (b / a);
    } else {
        r = b;
        phi = std::numbers::pi / 2.0 - std::numbers::pi / 4.0 * (a / b);
    }
    return {r * std::cos(phi), r * std::sin(phi), 0.0};
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
        const Ray pinhole = camera.castRay(x, y);
        const Vector3 focus = pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens = settings().dofAmount * sampleAperture();
            sum += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
