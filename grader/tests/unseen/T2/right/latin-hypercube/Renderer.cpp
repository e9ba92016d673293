// Latin hypercube ("n rooks") on lens and light: each of the n rows, columns and layers holds one
// point; which ones go together is shuffled anew each time.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace raytracer {
namespace {

std::vector<double> rooks(int n) {
    std::vector<double> places(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i)
        places[static_cast<std::size_t>(i)] = (i + randomBetween(0.0, 1.0)) / n;
    for (std::size_t i = places.size(); i > 1; --i)  // Fisher-Yates
        std::swap(places[i - 1], places[static_cast<std::size_t>(randomBetween(0.0, 1.0) *
                                                                 static_cast<double>(i))]);
    return places;
}

bool arrives(const Scene& scene, const Vector3& from, const Vector3& to) {
    const Vector3 way = to - from;
    const auto hit = scene.findClosestIntersection({from, way.normalised()});
    return !(hit && hit->distance < way.magnitude());
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
        const int n = settings().shadowRayCount;
        const auto heights = rooks(n), angles = rooks(n), radii = rooks(n);
        double share = 0.0;
        for (std::size_t i = 0; i < heights.size(); ++i) {
            const double z = 2.0 * heights[i] - 1.0;
            const double ring = std::sqrt(1.0 - z * z);
            const double angle = 2.0 * std::numbers::pi * angles[i];
            const Vector3 unit{ring * std::cos(angle), ring * std::sin(angle), z};
            const Vector3 aim =
                light.position() + unit * (std::cbrt(radii[i]) * settings().lightSize);
            if (arrives(scene, P + N * kShadowBias, aim)) share += 1.0 / n;
        }
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
        const Ray ray = camera.castRay(x, y);
        const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        const auto xs = rooks(settings().dofRayCount), ys = rooks(settings().dofRayCount);
        ColourRGB sum;
        for (std::size_t i = 0; i < xs.size(); ++i) {
            const Vector3 lens =
                Vector3{2.0 * xs[i] - 1.0, 2.0 * ys[i] - 1.0, 0.0} * settings().dofAmount;
            sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / static_cast<double>(xs.size()));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
