#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {
double radicalInverse(int base, int i) {
    double f = 1, r = 0;
    for (; i > 0; i /= base) {
        f /= base;
        r += f * (i % base);
    }
    return r;
}
double frac(double x) {
    return x - std::floor(x);
}

// The i-th of n points in the unit ball: shells of equal volume, golden-angle spiral, turned by
// three random numbers that belong to the point that is lit.
Vector3 spiral(int i, int n, double a, double b, double c) {
    const double r = std::cbrt((i + frac(a)) / n);
    const double z = 1 - 2 * frac(i * 0.754877666 + b);
    const double phi = 2 * std::numbers::pi * frac(i * std::numbers::phi + c);
    const double s = std::sqrt(std::max(0.0, 1 - z * z));
    return {r * s * std::cos(phi), r * s * std::sin(phi), r * z};
}
}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    ColourRGB sum = object.colour() * scene.ambientLighting();
    for (const PointLight& lamp : scene.pointLights()) {
        const Vector3 toLamp = lamp.position() - P;
        const Vector3 L = toLamp.normalised();
        const ColourRGB in = lamp.illuminationAt(toLamp.magnitude());
        ColourRGB lit = object.colour() * in * (object.phongKD() * std::max(N.dot(L), 0.0));
        lit += lamp.colour() * in *
               (object.phongKS() * std::pow(std::max(L.reflectIn(N).dot((O - P).normalised()), 0.0),
                                            object.phongAlpha()));
        const int n = settings().shadowRayCount;
        const double a = randomBetween(0, 1), b = randomBetween(0, 1), c = randomBetween(0, 1);
        double blocked = 0;
        for (int i = 0; i < n; ++i) {
            const Vector3 start = P + N * kShadowBias;
            const Vector3 way =
                lamp.position() + spiral(i, n, a, b, c) * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way});  // 1 is the lamp
            if (hit && hit->distance < 1.0) blocked += 1.0;
        }
        sum += lit * (1.0 - blocked / n);
    }
    return sum;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera(settings());
    Image image(settings());
    forEachPixel(image, [&](int x, int y) {
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 focus = d / d.z * settings().dofFocalPlane;
        const double shiftX = randomBetween(0, 1), shiftY = randomBetween(0, 1);
        ColourRGB mean;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens = Vector3{2 * frac(radicalInverse(2, i + 1) + shiftX) - 1,
                                         2 * frac(radicalInverse(3, i + 1) + shiftY) - 1, 0} *
                                 (settings().dofAmount / 2);
            mean += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces) *
                    (1.0 / settings().dofRayCount);
        }
        image.set(x, y, mean);
    });
    return image;
}
}  // namespace raytracer
