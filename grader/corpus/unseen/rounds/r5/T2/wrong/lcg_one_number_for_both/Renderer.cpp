// A tiny LCG, branch-free and inlined.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace raytracer {

namespace {
struct Lcg {
    std::uint32_t s;
    explicit Lcg(std::uint32_t seed) : s(seed * 747796405U + 2891336453U) {}
    std::uint32_t bits() { return s = s * 1664525U + 1013904223U; }
};
// Two coordinates from the halves of one draw: saves a multiplication.
struct Pair { double x, y; };
Pair split(std::uint32_t b) {
    const std::uint32_t high = b >> 16, low = (b & 0xFFFF0000U) >> 16;
    return {high / 32768.0 - 1.0, low / 32768.0 - 1.0};
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
        Lcg lcg{static_cast<std::uint32_t>(randomBetween(0.0, 4294967295.0))};
        const Ray r = camera.castRay(x, y);
        const Vector3 f = r.evaluateAt(settings().dofFocalPlane / r.direction.z);
        ColourRGB c;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Pair p = split(lcg.bits());
            const Vector3 e{p.x * settings().dofAmount, p.y * settings().dofAmount, 0.0};
            c += trace(scene, {e, (f - e).normalised()}, settings().bounces);
        }
        image.set(x, y, c / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
