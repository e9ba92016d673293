#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <cstdlib>
#include <ranges>
#include <random>
#include <vector>

namespace raytracer {

namespace {
thread_local std::mt19937_64 engine{std::random_device{}()};
Vector3 inBall(double radius) {
    std::normal_distribution<double> g;
    const Vector3 v{g(engine), g(engine), g(engine)};
    return v.normalised() * (radius * std::cbrt(std::generate_canonical<double, 53>(engine)));
}
}

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    ColourRGB total = object.colour() * scene.ambientLighting();
    for (const auto& lamp : scene.pointLights() | std::views::reverse) {
        const Vector3 d = lamp.position() - P;
        const Vector3 L = d.normalised();
        double seen = 0;
        for (int k = settings().shadowRayCount; k-- > 0;) {
            const Vector3 s = d + inBall(settings().lightSize);
            const auto hit = scene.findClosestIntersection({P + N * kShadowBias, s.normalised()});
            if (hit.has_value() && hit->distance < s.magnitude()) continue;
            seen += 1.0 / settings().shadowRayCount;
        }
        const ColourRGB I = lamp.illuminationAt(d.magnitude()) * seen;
        total += object.colour() * I * object.phongKD() * std::max(N.dot(L), 0.0);
        total += lamp.colour() * I * object.phongKS() * std::pow(std::max(L.reflectIn(N).dot((O - P).normalised()), 0.0), object.phongAlpha());
    }
    return total;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray middle = camera.castRay(x, y);
        const Vector3 focus = middle.evaluateAt(settings().dofFocalPlane / middle.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 eye{settings().dofAmount * (2 * drand48() - 1), settings().dofAmount * (2 * drand48() - 1), 0};
            sum += trace(scene, Ray{eye, (focus - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
