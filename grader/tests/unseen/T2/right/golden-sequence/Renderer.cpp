#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace raytracer {
namespace {
// Roberts' generalised golden ratio: one endless sequence, every sample takes the next element.
class Sequence {
public:
    struct Triple {
        double a, b, c;
    };
    Triple next() {
        const double i = static_cast<double>(counter_++ % 100000000);
        return {part(0.5 + i * 0.8191725133961645), part(0.5 + i * 0.6710436067037893),
                part(0.5 + i * 0.5497004779019703)};
    }

private:
    static double part(double x) { return x - std::floor(x); }
    std::atomic<std::uint64_t> counter_{1};
};
Sequence lampSequence;
Sequence lensSequence;

Vector3 ball() {
    const auto [a, b, c] = lampSequence.next();
    const double r = std::cbrt(a), z = 2 * b - 1, s = std::sqrt(1 - z * z),
                 t = 2 * std::numbers::pi * c;
    return Vector3{s * std::cos(t), s * std::sin(t), z} * r;
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
        const ColourRGB full =
            object.colour() * arriving * (object.phongKD() * std::max(0.0, N.dot(toLight))) +
            light.colour() * arriving *
                (object.phongKS() *
                 std::pow(std::max(0.0, toLight.reflectIn(N).dot(toViewer)), object.phongAlpha()));
        const ColourRGB step = full / settings().shadowRayCount;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 from = P + N * kShadowBias;
            const Vector3 to = light.position() + ball() * settings().lightSize;
            const auto hit = scene.findClosestIntersection({from, (to - from).normalised()});
            if (!hit || hit->distance >= (to - from).magnitude()) colour += step;
        }
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray ray = camera.castRay(x, y);
        const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const auto p = lensSequence.next();
            const Vector3 from = Vector3{2 * p.a - 1, 2 * p.c - 1, 0} * settings().dofAmount;
            sum += trace(scene, {from, (focus - from).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}
}  // namespace raytracer
