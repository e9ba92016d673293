// 32 x 32 tiles stay in the cache.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <thread>
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
        const Vector3 from = P + N * kShadowBias;
        double lit = 0.0;
        for (int k = settings().shadowRayCount; k-- > 0;) {
            const Vector3 way = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - from;
            const double length = way.magnitude();
            const auto blocker = scene.findClosestIntersection({from, way / length});
            lit += blocker && blocker->distance < length ? 0.0 : 1.0;
        }
        lit /= settings().shadowRayCount;
        colour += lit * diffuse + lit * specular;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    // TASK T2.2 begin
    constexpr int kTile = 32;
    const int columns = std::max(1, image.width() / kTile);
    const int rows = std::max(1, image.height() / kTile);
    std::atomic<int> next{0};
    const auto worker = [&] {
        for (int tile; (tile = next++) < columns * rows;) {
            seedRandom(settings().seed * 1000003U + static_cast<std::uint64_t>(tile));
            for (int i = 0; i < kTile * kTile; ++i) {
                const int x = tile % columns * kTile + i % kTile;
                const int y = tile / columns * kTile + i / kTile;
                if (x >= image.width() || y >= image.height()) continue;
                const Ray ray = camera.castRay(x, y);
                const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
                ColourRGB sum;
                for (int k = 0; k < settings().dofRayCount; ++k) {
                    const double lx = settings().dofAmount * randomBetween(-1, 1);
                    const double ly = settings().dofAmount * randomBetween(-1, 1);
                    const Vector3 lens{lx, ly, 0};
                    sum += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
                }
                image.set(x, y, sum / settings().dofRayCount);
            }
        }
    };
    std::vector<std::thread> pool;
    for (int i = 1; i < settings().threads; ++i) pool.emplace_back(worker);
    worker();
    for (auto& t : pool) t.join();
    // TASK T2.2 end
    return image;
}

}  // namespace raytracer
