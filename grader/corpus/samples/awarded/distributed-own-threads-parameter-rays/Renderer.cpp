#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

namespace raytracer {


ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    ColourRGB total = object.colour() * scene.ambientLighting();
    for (const auto& light : scene.pointLights()) {
        const Vector3 d = light.position() - P;
        const double far = d.magnitude();
        const Vector3 L = d / far;
        int clear = 0;
        for (int k = 0; k < settings().shadowRayCount; k++) {
            const Vector3 goal = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const Vector3 from = P + kShadowBias * N;
            const auto hit = scene.findClosestIntersection({from, goal - from});
            if (!(hit.has_value() && hit->distance < 1.0)) clear++;
        }
        const double share = clear / static_cast<double>(settings().shadowRayCount);
        const ColourRGB I = light.illuminationAt(far);
        const double cosine = std::max(N.dot(L), 0.0);
        const double shine = std::pow(std::max(L.reflectIn(N).dot((O - P).normalised()), 0.0), object.phongAlpha());
        total += object.colour() * I * (object.phongKD() * cosine * share);
        total += light.colour() * I * (object.phongKS() * shine * share);
    }
    return total;
}

Image Renderer::render(const Scene& scene) const {
    Image image{settings()};
    const Camera camera{settings()};
    auto band = [&](int first, int step) {
        seedRandom(settings().seed * 31 + static_cast<unsigned>(first));
        for (int y = first; y < image.height(); y += step) {
            for (int x = 0; x < image.width(); ++x) {
                const Ray r = camera.castRay(x, y);
                const double t = settings().dofFocalPlane / r.direction.z;
                ColourRGB c{0, 0, 0};
                for (int k = 0; k < settings().dofRayCount; ++k) {
                    const double a = settings().dofAmount;
                    const Vector3 e{randomBetween(-a, a), randomBetween(-a, a), 0.0};
                    c += trace(scene, Ray{e, (r.evaluateAt(t) - e).normalised()}, settings().bounces);
                }
                image.set(x, y, c / settings().dofRayCount);
            }
        }
    };
    std::vector<std::thread> workers;
    for (int i = 0; i < 2; ++i) workers.emplace_back(band, i, 2);
    for (auto& worker : workers) worker.join();
    return image;
}

}  // namespace raytracer
