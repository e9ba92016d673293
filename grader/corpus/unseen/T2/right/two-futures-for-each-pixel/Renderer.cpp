// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <cstdint>
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
        int arrived = 0;
        const Vector3 from = P + kShadowBias * N;
        for (int k = 0; k < settings().shadowRayCount; k++) {
            const Vector3 spot = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const double reach = (spot - from).magnitude();
            const auto hit = scene.findClosestIntersection(Ray(from, (spot - from) / reach));
            if (!hit.has_value() || hit->distance > reach) arrived++;
        }
        colour += (diffuse + specular) * (double(arrived) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray middle = camera.castRay(x, y);
        const Vector3 focus = middle.evaluateAt(settings().dofFocalPlane / middle.direction.z);
        std::vector<Ray> rays;
        rays.reserve(static_cast<std::size_t>(settings().dofRayCount));
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double lx = randomBetween(-settings().dofAmount, settings().dofAmount);
            const double ly = randomBetween(-settings().dofAmount, settings().dofAmount);
            const Vector3 lens{lx, ly, 0.0};
            rays.emplace_back(lens, (focus - lens).normalised());
        }
        const auto add = [&](std::size_t first, std::size_t last) {
            ColourRGB sum;
            for (std::size_t i = first; i < last; ++i) sum += trace(scene, rays[i], settings().bounces);
            return sum;
        };
        const std::size_t half = rays.size() / 2;
        // Threads that were not seeded draw different numbers: a stream from this pixel's own.
        const auto seed = static_cast<std::uint64_t>(randomBetween(0.0, 9e15));
        std::future<ColourRGB> other = std::async(std::launch::async, [&] {
            seedRandom(seed);
            return add(half, rays.size());
        });
        const ColourRGB mine = add(0, half);
        image.set(x, y, (mine + other.get()) / static_cast<double>(rays.size()));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
