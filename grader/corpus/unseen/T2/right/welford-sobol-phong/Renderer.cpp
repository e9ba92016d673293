// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace raytracer {
namespace {

class RunningMean {
public:
    void add(const ColourRGB& c) { mean_ += (c - mean_) / ++count_; }
    const ColourRGB& value() const { return mean_; }

private:
    ColourRGB mean_;
    double count_ = 0.0;
};

std::uint32_t randomBits() {
    return static_cast<std::uint32_t>(randomBetween(0.0, 4294967296.0));
}

std::uint32_t vanDerCorput(std::uint32_t bits) {
    std::uint32_t r = 0;
    for (std::uint32_t v = 1U << 31U; bits != 0; bits >>= 1U, v >>= 1U)
        if (bits & 1U) r ^= v;
    return r;
}

std::uint32_t sobol2(std::uint32_t bits) {
    std::uint32_t r = 0;
    for (std::uint32_t v = 1U << 31U; bits != 0; bits >>= 1U, v ^= v >> 1U)
        if (bits & 1U) r ^= v;
    return r;
}

}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 toViewer = (O - P).normalised();
    ColourRGB colour = object.colour() * scene.ambientLighting();
    const Vector3 origin = P + N * kShadowBias;

    for (const PointLight& light : scene.pointLights()) {
        // TASK T2.1 begin
        RunningMean direct;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 place =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 way = place - origin;
            const double length = way.magnitude();
            const auto blocker = scene.findClosestIntersection(Ray{origin, way.normalised()});
            ColourRGB here;  // black where the ray does not arrive
            if (!blocker || blocker->distance > length) {
                const Vector3 L = (place - P).normalised();
                const ColourRGB arriving = light.illuminationAt((place - P).magnitude());
                const double facing = std::max(0.0, N.dot(L));
                const double mirrored = std::max(0.0, L.reflectIn(N).dot(toViewer));
                here = object.colour() * arriving * (object.phongKD() * facing) +
                       light.colour() * arriving *
                           (object.phongKS() * std::pow(mirrored, object.phongAlpha()));
            }
            direct.add(here);
        }
        colour += direct.value();
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray ray = camera.castRay(x, y);
        const Vector3 focal = ray.evaluateAt((settings().dofFocalPlane - ray.origin.z) / ray.direction.z);
        const std::uint32_t maskX = randomBits();
        const std::uint32_t maskY = randomBits();
        RunningMean mean;
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(settings().dofRayCount); ++i) {
            const double u = (vanDerCorput(i) ^ maskX) * 0x1p-31 - 1.0;
            const double v = (sobol2(i) ^ maskY) * 0x1p-31 - 1.0;
            const Vector3 from = ray.origin + Vector3{u, v, 0.0} * settings().dofAmount;
            mean.add(trace(scene, Ray{from, (focal - from).normalised()}, settings().bounces));
        }
        image.set(x, y, mean.value());
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
