// Tiles of rows by my own threads, as many as settings().threads.
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
    constexpr int kTile = 8;
    const int tilesX = (image.width() + kTile - 1) / kTile;
    const int tilesY = (image.height() + kTile - 1) / kTile;
    std::atomic<int> next{0};

    const auto pixel = [&](int x, int y) {
        const Region region = settings().region.isWholeFrame() ? Region{} : settings().region;
        seedRandom((settings().seed * 65537U + static_cast<std::uint64_t>(region.y + y)) * 65537U +
                   static_cast<std::uint64_t>(region.x + x));
        const Ray middle = camera.castRay(x, y);
        const Vector3 focus = middle.evaluateAt(settings().dofFocalPlane / middle.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double dx = settings().dofAmount * randomBetween(-1.0, 1.0);
            const double dy = settings().dofAmount * randomBetween(-1.0, 1.0);
            const Vector3 from{dx, dy, 0.0};
            sum += trace(scene, Ray{from, (focus - from).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    };
    const auto work = [&] {
        for (int t = next++; t < tilesX * tilesY; t = next++) {
            const int x0 = t % tilesX * kTile, y0 = t / tilesX * kTile;
            for (int y = y0; y < std::min(y0 + kTile, image.height()); ++y)
                for (int x = x0; x < std::min(x0 + kTile, image.width()); ++x) pixel(x, y);
        }
    };
    std::vector<std::thread> helpers;
    for (int i = 1; i < settings().threads; ++i) helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers) helper.join();
    // TASK T2.2 end
    return image;
}

}  // namespace raytracer
