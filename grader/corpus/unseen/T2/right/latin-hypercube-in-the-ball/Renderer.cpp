#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace raytracer {
namespace {

/// One random number in each of `count` equal parts of [0, 1], in random order.
std::vector<double> strata(int count) {
    std::vector<double> values(count);
    for (int i = 0; i < count; ++i) values[i] = (i + randomBetween(0, 1)) / count;
    for (int i = count - 1; i > 0; --i)
        std::swap(values[i], values[static_cast<int>(randomBetween(0, i + 1))]);
    return values;
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
        const int count = settings().shadowRayCount;
        const std::vector<double> radii = strata(count), heights = strata(count), turns = strata(count);
        const Vector3 start = P + N * kShadowBias;
        int arrived = 0;
        for (int i = 0; i < count; ++i) {
            const double r = settings().lightSize * std::cbrt(radii[i]);
            const double z = 1.0 - 2.0 * heights[i];
            const double ring = std::sqrt(std::max(0.0, 1.0 - z * z));
            const double phi = 2.0 * std::numbers::pi * turns[i];
            const Vector3 target = light.position() + r * Vector3{ring * std::cos(phi), ring * std::sin(phi), z};
            const Vector3 way = target - start;
            const auto hit = scene.findClosestIntersection({start, way.normalised()});
            arrived += !hit || hit->distance > way.magnitude();
        }
        colour += (diffuse + specular) * (double(arrived) / count);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray pinhole = camera.castRay(x, y);
        const Vector3 focus = pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
        const int count = settings().dofRayCount;
        const int side = static_cast<int>(std::sqrt(static_cast<double>(count)));
        ColourRGB sum;
        for (int i = 0; i < count; ++i) {
            double s = randomBetween(0, 1), t = randomBetween(0, 1);
            if (i < side * side) {  // the rest of the rays goes anywhere
                s = (i % side + s) / side;
                t = (i / side + t) / side;
            }
            const Vector3 lens{settings().dofAmount * (2 * s - 1), settings().dofAmount * (2 * t - 1), 0};
            sum += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / count);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
