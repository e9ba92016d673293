// Quasi Monte Carlo with Halton numbers (bases 2, 3, 5).
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace raytracer {

namespace {
struct Halton3 {
    Vector3 shift{randomBetween(0, 1), randomBetween(0, 1), randomBetween(0, 1)};
    static double phi(int b, int i) {
        double v = 0;
        for (double f = 1.0 / b; i > 0; i /= b, f /= b) v += f * (i % b);
        return v;
    }
    static double wrap(double t) { return 2 * (t - std::floor(t)) - 1; }
    Vector3 operator()(int i) const {
        return {wrap(phi(2, i) + shift.x), wrap(phi(3, i) + shift.y), wrap(phi(5, i) + shift.z)};
    }
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
        const Halton3 halton;
        const Vector3 start = P + N * kShadowBias;
        int reached = 0;
        for (int i = 1; i <= settings().shadowRayCount; ++i) {
            const Vector3 target = light.position() + settings().lightSize * halton(i);
            const auto hit = scene.findClosestIntersection({start, (target - start).normalised()});
            if (!hit || hit->distance > (target - start).magnitude()) ++reached;
        }
        colour += (diffuse + specular) * (static_cast<double>(reached) / settings().shadowRayCount);
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
        const Vector3 F = d * (settings().dofFocalPlane / d.z);
        const int n = settings().dofRayCount;
        ColourRGB mean;
        for (int i = 0; i < n; ++i) {
            Vector3 lens;
            lens.x = settings().dofAmount * randomBetween(-1.0, 1.0);
            lens.y = settings().dofAmount * randomBetween(-1.0, 1.0);
            mean += trace(scene, {lens, (F - lens).normalised()}, settings().bounces) * (1.0 / n);
        }
        image.set(x, y, mean);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
