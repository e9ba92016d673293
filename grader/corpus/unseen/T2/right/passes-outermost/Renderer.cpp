// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <numbers>
#include <thread>
#include <vector>

namespace raytracer {
namespace {

std::uint64_t scrambled(std::uint64_t seed, std::uint64_t pass, std::uint64_t row) {
    std::uint64_t z = seed * 0xD1342543DE82EF95ULL + pass * 0x9E3779B97F4A7C15ULL + (row << 40U);
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
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
        const Vector3 above = P + N * kShadowBias;
        int seen = 0;
        for (int ray = 0; ray != settings().shadowRayCount; ++ray) {
            const Vector3 surface = Vector3::randomInsideUnitSphere().normalised() * settings().lightSize;
            const Vector3 target = light.position() + surface;
            const double reach = (target - above).magnitude();
            const auto thing = scene.findClosestIntersection(Ray{above, (target - above) / reach});
            if (thing && thing->distance < reach) continue;
            seen++;
        }
        colour += diffuse * (seen / double(settings().shadowRayCount));
        colour += specular * (seen / double(settings().shadowRayCount));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    // TASK T2.2 begin
    const std::size_t w = static_cast<std::size_t>(image.width());
    const std::size_t h = static_cast<std::size_t>(image.height());
    const int passes = settings().dofRayCount;
    std::vector<ColourRGB> buffer(w * h);
    std::vector<std::mutex> rowLocks(h);
    std::atomic<int> nextPass{0};

    const auto worker = [&] {
        std::vector<ColourRGB> row(w);
        for (int pass = nextPass++; pass < passes; pass = nextPass++) {
            for (std::size_t y = 0; y < h; ++y) {
                seedRandom(scrambled(settings().seed, static_cast<std::uint64_t>(pass), y));
                for (std::size_t x = 0; x < w; ++x) {
                    Ray ray = camera.castRay(static_cast<int>(x), static_cast<int>(y));
                    const Vector3 focal = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
                    ray.origin.x += settings().dofAmount * randomBetween(-1.0, 1.0);
                    ray.origin.y += settings().dofAmount * randomBetween(-1.0, 1.0);
                    ray.direction = (focal - ray.origin).normalised();
                    row[x] = trace(scene, ray, settings().bounces);
                }
                const std::lock_guard guard{rowLocks[y]};
                for (std::size_t x = 0; x < w; ++x)
                    buffer[y * w + x] += row[x];
            }
        }
    };
    std::vector<std::thread> team;
    for (int i = 1; i < settings().threads; ++i)
        team.emplace_back(worker);
    worker();
    for (std::thread& member : team)
        member.join();

    for (std::size_t y = 0; y < h; ++y)
        for (std::size_t x = 0; x < w; ++x)
            image.set(static_cast<int>(x), static_cast<int>(y), buffer[y * w + x] / passes);
    // TASK T2.2 end
    return image;
}

}  // namespace raytracer
