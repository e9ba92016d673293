// Camera rays in packets of eight.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <array>
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
        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            const Vector3 aim = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const Vector3 from = P + kShadowBias * N;
            const auto hit = scene.findClosestIntersection(Ray(from, (aim - from).normalised()));
            if (!hit.has_value() || hit->distance >= (aim - from).magnitude()) arrived++;
        }
        colour += (diffuse + specular) * (double(arrived) / double(settings().shadowRayCount));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        constexpr int kLanes = 8;
        struct Lanes { std::array<double, kLanes> r{}, g{}, b{}; } acc;
        const Ray pinhole = camera.castRay(x, y);
        const Vector3 focus = pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
        const int packets = (settings().dofRayCount + kLanes - 1) / kLanes;  // round up
        for (int p = 0; p < packets; ++p) {
            for (int k = 0; k < kLanes; ++k) {
                const double lx = settings().dofAmount * randomBetween(-1, 1);
                const double ly = settings().dofAmount * randomBetween(-1, 1);
                const Vector3 lens{lx, ly, 0};
                const ColourRGB c = trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
                acc.r[k] += c.r;
                acc.g[k] += c.g;
                acc.b[k] += c.b;
            }
        }
        ColourRGB sum;
        for (int k = 0; k < kLanes; ++k) sum += ColourRGB{acc.r[k], acc.g[k], acc.b[k]};
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
