#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace raytracer {


static double halton(int index, int base) {
    double result = 0, f = 1;
    for (int i = index; i > 0; i /= base) {
        f /= base;
        result += f * (i % base);
    }
    return result;
}
static double fractionOf(double v) { return v - std::floor(v); }

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const int n = settings().shadowRayCount;
    const Vector3 V = (O - P).normalised();
    ColourRGB result = object.colour() * scene.ambientLighting();
    for (const PointLight& light : scene.pointLights()) {
        const ColourRGB I = light.illuminationAt((light.position() - P).magnitude());
        for (int i = 0; i < n; ++i) {
            const Vector3 S = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 L = (S - P).normalised();
            const std::optional<RaycastHit> blocked = scene.findClosestIntersection(Ray{P + L * 1e-4, L});
            if (blocked && blocked->distance < (S - P).magnitude()) continue;
            result += object.colour() * I * (object.phongKD() * std::max(0.0, N.dot(L)) / n);
            result += light.colour() * I * (object.phongKS() * std::pow(std::max(0.0, V.dot(L.reflectIn(N))), object.phongAlpha()) / n);
        }
    }
    return result;
}

Image Renderer::render(const Scene& scene) const {
    Image image{settings()};
    const Camera camera{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray central = camera.castRay(x, y);
        const Vector3 target = central.evaluateAt(settings().dofFocalPlane / central.direction.z);
        const double a = randomBetween(0, 1), b = randomBetween(0, 1);
        ColourRGB mean;
        for (int i = 1; i <= settings().dofRayCount; ++i) {
            const Vector3 eye{(2 * fractionOf(halton(i, 2) + a) - 1) * settings().dofAmount,
                              (2 * fractionOf(halton(i, 3) + b) - 1) * settings().dofAmount, 0};
            mean = mean + (trace(scene, {eye, (target - eye).normalised()}, settings().bounces) - mean) * (1.0 / i);
        }
        image.set(x, y, mean);
    });
    return image;
}

}  // namespace raytracer
