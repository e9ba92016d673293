// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

double radicalInverse(unsigned base, unsigned i) {
    double value = 0.0;
    double digit = 1.0;
    for (; i > 0; i /= base) {
        digit /= base;
        value += digit * (i % base);
    }
    return value;
}

double wrapped(double a) {
    return a - std::floor(a);
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
        const double shiftRadius = randomBetween(0.0, 1.0);
        const double shiftHeight = randomBetween(0.0, 1.0);
        const double shiftTurn = randomBetween(0.0, 1.0);
        const Vector3 start = P + N * kShadowBias;
        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const unsigned k = static_cast<unsigned>(i) + 1U;
            const double radius = std::cbrt(wrapped(radicalInverse(2, k) + shiftRadius));
            const double height = 1.0 - 2.0 * wrapped(radicalInverse(3, k) + shiftHeight);
            const double turn = 2.0 * std::numbers::pi * wrapped(radicalInverse(5, k) + shiftTurn);
            const double side = std::sqrt(std::max(0.0, 1.0 - height * height));
            const Vector3 onBall{side * std::cos(turn), side * std::sin(turn), height};
            const Vector3 way = light.position() + onBall * (radius * settings().lightSize) - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
            if (!hit || hit->distance > way.magnitude()) ++arrived;
        }
        colour += (diffuse + specular) * (static_cast<double>(arrived) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray central = camera.castRay(x, y);
        const Vector3 focus = central.evaluateAt(settings().dofFocalPlane / central.direction.z);
        const double shiftX = randomBetween(0.0, 1.0);
        const double shiftY = randomBetween(0.0, 1.0);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const unsigned k = static_cast<unsigned>(i) + 1U;
            const double u = 2.0 * wrapped(radicalInverse(2, k) + shiftX) - 1.0;
            const double v = 2.0 * wrapped(radicalInverse(3, k) + shiftY) - 1.0;
            const Vector3 lens{u * settings().dofAmount, v * settings().dofAmount, 0.0};
            sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
