// Option 2, tasks T2.1 and T2.2.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <future>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <ranges>
#include <utility>
#include <vector>

namespace raytracer {
namespace {

/// Mitchell's best candidates in the ball: the farthest of four from all before.
std::vector<Vector3> blueBall(int n) {
    std::vector<Vector3> points;
    while (int(points.size()) < n) {
        Vector3 best;
        double farthest = -1;
        for (int c = 0; c < 4; ++c) {
            const Vector3 q = Vector3::randomInsideUnitSphere();
            double nearest = 10;
            for (const Vector3& p : points) nearest = std::min(nearest, (p - q).dot(p - q));
            if (nearest > farthest) { farthest = nearest; best = q; }
        }
        points.push_back(best);
    }
    return points;
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
        const Vector3 start = P + N * kShadowBias;
        double hits = 0, all = 0;
        for (const Vector3& q : blueBall(settings().shadowRayCount)) {
            const Vector3 way = light.position() + q * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
            hits += !hit || hit->distance > way.magnitude();
            all += 1;
        }
        colour += (diffuse + specular) * (hits / all);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray pin = camera.castRay(x, y);
        const Vector3 focal = pin.evaluateAt(settings().dofFocalPlane / pin.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens{settings().dofAmount * randomBetween(-1, 1), settings().dofAmount * randomBetween(-1, 1), 0};
            const ColourRGB c = trace(scene, Ray{lens, (focal - lens).normalised()}, settings().bounces);
            sum += {std::pow(c.r, 1 / 2.2), std::pow(c.g, 1 / 2.2), std::pow(c.b, 1 / 2.2)};
        }
        sum /= settings().dofRayCount;
        image.set(x, y, {std::pow(sum.r, 2.2), std::pow(sum.g, 2.2), std::pow(sum.b, 2.2)});
    });
    return image;
}

}  // namespace raytracer
