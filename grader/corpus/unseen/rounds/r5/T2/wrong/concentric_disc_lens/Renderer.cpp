// Shirley and Chiu: concentric map, keeps strata compact.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace raytracer {

namespace {
std::pair<double, double> concentric(double a, double b) {
    if (a == 0.0 && b == 0.0) return {0.0, 0.0};
    constexpr double q = std::numbers::pi / 4.0;
    const bool wide = std::abs(a) > std::abs(b);
    const double r = wide ? a : b;
    const double t = wide ? q * (b / a) : 2.0 * q - q * (a / b);
    return {r * std::cos(t), r * std::sin(t)};
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
        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            const Vector3 aim = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const Vector3 from = P + kShadowBias * N;
            const auto hit = scene.findClosestIntersection(Ray(from, (aim - from).normalised()));
            if (!hit.has_value() || hit->distance >= (aim - from).magnitude()) arrived++;
        }
        colour += (diffuse + specular) * (double(arrived) / double(settings().shadowRayCount));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray chief = camera.castRay(x, y);
        const Vector3 focal = chief.evaluateAt(settings().dofFocalPlane / chief.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double a = randomBetween(-1, 1), b = randomBetween(-1, 1);
            const auto [dx, dy] = concentric(a, b);
            const Vector3 lens = settings().dofAmount * Vector3{dx, dy, 0.0};
            sum += trace(scene, Ray{lens, (focal - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
