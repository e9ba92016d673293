// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <functional>
#include <random>
#include <thread>

namespace raytracer {
namespace {

class Sampler {
public:
    static Sampler& ofThisThread() {
        thread_local Sampler sampler{std::hash<std::thread::id>{}(std::this_thread::get_id())};
        return sampler;
    }
    /// Uniform in the ball: a Gaussian vector has no favourite direction.
    [[nodiscard]] Vector3 ball(double radius) {
        Vector3 g;
        do {
            g = {gauss_(engine_), gauss_(engine_), gauss_(engine_)};
        } while (g.dot(g) == 0.0);
        return g.normalised() * (radius * std::cbrt(unit_(engine_)));
    }
    [[nodiscard]] Vector3 square(double half) {
        const double x = half * (2.0 * unit_(engine_) - 1.0);
        const double y = half * (2.0 * unit_(engine_) - 1.0);
        return {x, y, 0.0};
    }

private:
    explicit Sampler(std::size_t seed) : engine_(seed) {}
    std::mt19937_64 engine_;
    std::normal_distribution<double> gauss_;
    std::uniform_real_distribution<double> unit_;
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
        Sampler& sampler = Sampler::ofThisThread();
        const Vector3 start = P + N * kShadowBias;
        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 way = light.position() + sampler.ball(settings().lightSize) - start;
            const double length = way.magnitude();
            const auto hit = scene.findClosestIntersection({start, way / length});
            if (!hit || hit->distance > length) ++arrived;
        }
        colour += (diffuse + specular) * (1.0 * arrived / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        Sampler& sampler = Sampler::ofThisThread();
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 focus = d * (settings().dofFocalPlane / d.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens = sampler.square(settings().dofAmount);
            sum += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
