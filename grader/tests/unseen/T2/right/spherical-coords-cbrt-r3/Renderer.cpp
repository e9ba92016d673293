// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {
Vector3 inBall(double R) {
    const double z = randomBetween(-1, 1), a = randomBetween(0, 2 * std::numbers::pi);
    const double r = R * std::cbrt(randomBetween(0, 1)), s = std::sqrt(1 - z * z);
    return {r * s * std::cos(a), r * s * std::sin(a), r * z};
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
        auto sees = [&](const Vector3& a, const Vector3& b) {
            auto hit = scene.findClosestIntersection({a, b - a});
            return !(hit && hit->distance < 1);
        };
        unsigned ok = 0;
        for (int i = 0; i != settings().shadowRayCount; i++)
            ok += sees(P + N * kShadowBias, light.position() + inBall(settings().lightSize));
        colour += (diffuse + specular) * (ok * 1.0 / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const double A = settings().dofAmount;
        const auto pin = camera.castRay(x, y);
        const auto F = pin.evaluateAt(settings().dofFocalPlane / pin.direction.z);
        double r = 0, g = 0, b = 0;
        int n = 0;
        while (n < settings().dofRayCount) {
            const Vector3 lens(randomBetween(-A, A), randomBetween(-A, A), 0.0);
            const ColourRGB c = trace(scene, {lens, (F - lens).normalised()}, settings().bounces);
            r += c.r; g += c.g; b += c.b;
            ++n;
        }
        image.set(x, y, {r / n, g / n, b / n});
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
