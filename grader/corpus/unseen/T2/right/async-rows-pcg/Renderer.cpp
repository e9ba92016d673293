// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/RenderObserver.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <future>
#include <numbers>
#include <vector>

namespace raytracer {
namespace {

/// O'Neill's PCG-XSH-RR.
class Pcg32 {
public:
    explicit Pcg32(std::uint64_t seed) {
        next();
        state_ += seed * 0x9E3779B97F4A7C15ULL;
        next();
    }
    std::uint32_t next() {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005ULL + 1442695040888963407ULL;
        const auto shifted = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
        const auto turn = static_cast<std::uint32_t>(old >> 59U);
        return (shifted >> turn) | (shifted << ((32U - turn) & 31U));
    }
    double unit() { return next() * 0x1p-32; }

private:
    std::uint64_t state_ = 0;
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
        const int rays = settings().shadowRayCount;
        int blocked = 0;
        for (int i = 0; i < rays; ++i) {
            const Vector3 place = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const Vector3 towards = (place - P).normalised();
            const auto occluder = scene.findClosestIntersection({P + towards * kShadowBias, towards});
            blocked += occluder.has_value() && occluder->distance < distance;
        }
        colour += (diffuse + specular) * (1.0 - static_cast<double>(blocked) / rays);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    // TASK T2.2 begin
    const double half = settings().dofAmount / 2.0;
    const auto renderRow = [&](int y) {
        const std::uint64_t key = settings().seed * 1000003U + static_cast<std::uint64_t>(y);
        Pcg32 pcg{key};
        seedRandom(key ^ 0x5DEECE66DULL);
        for (int x = 0; x < image.width(); ++x) {
            const Ray pin = camera.castRay(x, y);
            const Vector3 focal = pin.evaluateAt(settings().dofFocalPlane / pin.direction.z);
            ColourRGB sum;
            for (int n = settings().dofRayCount; n > 0; --n) {
                const double dx = half * (2.0 * pcg.unit() - 1.0);
                const double dy = half * (2.0 * pcg.unit() - 1.0);
                const Vector3 from = pin.origin + Vector3{dx, dy, 0.0};
                sum += trace(scene, {from, (focal - from).normalised()}, settings().bounces);
            }
            image.set(x, y, sum / settings().dofRayCount);
        }
    };
    const int wave = std::max(1, settings().threads);
    int done = 0;
    for (int first = 0; first < image.height(); first += wave) {
        if (settings().monitor != nullptr && settings().monitor->interrupted()) break;
        std::vector<std::future<void>> rows;
        for (int y = first; y < std::min(first + wave, image.height()); ++y)
            rows.push_back(std::async(std::launch::async, renderRow, y));
        for (std::size_t i = 0; i < rows.size(); ++i) {
            rows[i].get();
            ++done;
            if (settings().monitor != nullptr)
                settings().monitor->rowFinished(first + static_cast<int>(i), done, image.height());
        }
    }
    // TASK T2.2 end
    return image;
}

}  // namespace raytracer
