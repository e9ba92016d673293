// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <raytracer/base/RenderObserver.h>

#include <atomic>
#include <future>
#include <vector>

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
        int blocked = 0;
        for (int k = 0; k != settings().shadowRayCount; ++k) {
            Vector3 offset = Vector3::randomInsideUnitSphere();
            offset *= settings().lightSize;
            const Vector3 origin = P + kShadowBias * N;
            const Vector3 d = light.position() + offset - origin;
            const double reach = d.magnitude();
            if (const auto h = scene.findClosestIntersection({origin, d / reach}); h && h->distance < reach) ++blocked;
        }
        colour += (diffuse + specular) * (1.0 - static_cast<double>(blocked) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    // TASK T2.2 begin
    const int tasks = std::clamp(settings().threads, 1, image.height());
    std::atomic<int> finished{0};

    const auto renderPixel = [&](int x, int y) {
        const Ray pinhole = camera.castRay(x, y);
        const Vector3 focus = pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 eye{randomBetween(-settings().dofAmount, settings().dofAmount),
                              randomBetween(-settings().dofAmount, settings().dofAmount), 0.0};
            sum += trace(scene, {eye, (focus - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    };
    const auto renderEvery = [&](int first) {  // rows first, first + tasks, ...
        for (int y = first; y < image.height(); y += tasks) {
            if (settings().monitor != nullptr && settings().monitor->interrupted()) return;
            const auto row = static_cast<std::uint64_t>(settings().region.y + y);
            for (int x = 0; x < image.width(); ++x) {
                const auto column = static_cast<std::uint64_t>(settings().region.x + x);
                seedRandom((settings().seed + 1U) * 0x9E3779B97F4A7C15U + (row << 32U) + column);
                renderPixel(x, y);
            }
            const int done = ++finished;
            if (settings().monitor != nullptr) settings().monitor->rowFinished(y, done, image.height());
        }
    };

    std::vector<std::future<void>> others;
    for (int i = 1; i < tasks; ++i) others.push_back(std::async(std::launch::async, renderEvery, i));
    renderEvery(0);
    for (auto& other : others) other.get();
    // TASK T2.2 end
    return image;
}

}  // namespace raytracer
