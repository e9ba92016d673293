#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <atomic>
#include <random>
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

        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 aim = light.position() + Vector3::randomInsideUnitSphere().normalised() * settings().lightSize;
            const Vector3 start = P + N * kShadowBias;
            const std::optional<RaycastHit> hit = scene.findClosestIntersection(Ray{start, (aim - start).normalised()});
            if (!hit || hit->distance > (aim - start).magnitude()) ++arrived;
        }
        colour += (diffuse + specular) * (static_cast<double>(arrived) / settings().shadowRayCount);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const RenderSettings& s = settings();
    Image image(s);
    const int x0 = s.region.isWholeFrame() ? 0 : s.region.x, y0 = s.region.isWholeFrame() ? 0 : s.region.y;
    const Vector3 eye{0, 0, 0}, forward{0, 0, 1}, worldUp{0, 1, 0};
    const Vector3 right = worldUp.cross(forward).normalised(), up = forward.cross(right).normalised();
    const double halfWidth = std::tan(22.5 * std::numbers::pi / 180), halfHeight = halfWidth * s.height / s.width;
    std::vector<int> order;
    for (int i = 0; i < image.width() * image.height(); ++i) order.push_back(i);
    std::shuffle(order.begin(), order.end(), std::mt19937(7));
    std::atomic<std::size_t> next{0};
    auto work = [&](unsigned seed) {
        std::mt19937 g(seed);
        std::uniform_real_distribution<double> d(-s.dofAmount, s.dofAmount);
        for (std::size_t k = next++; k < order.size(); k = next++) {
            const int px = order[k] % image.width(), py = order[k] / image.width();
            const double sx = (2 * (px + x0 + 0.5) / s.width - 1) * halfWidth, sy = (1 - 2 * (py + y0 + 0.5) / s.height) * halfHeight;
            const Vector3 focal = eye + (forward + right * sx + up * sy) * s.dofFocalPlane;
            ColourRGB c(0);
            for (int i = 0; i < s.dofRayCount; ++i) {
                const Vector3 o = eye + right * d(g) + up * d(g);
                c += trace(scene, Ray(o, (focal - o).normalised()), s.bounces);
            }
            image.set(px, py, c / s.dofRayCount);
        }
    };
    std::vector<std::thread> pool;
    for (unsigned t = 1; t <= 3; ++t) pool.emplace_back(work, 1000 * t + 17);
    for (auto& t : pool) t.join();
    return image;
}

}  // namespace raytracer
