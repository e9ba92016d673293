#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

namespace raytracer {
namespace {
// Mitchell's best candidate on a torus, so that the edges of the square are no better than the
// middle.
std::vector<Vector3> blueNoise(int count) {
    std::vector<Vector3> points;
    const auto gap = [](const Vector3& a, const Vector3& b) {
        const double dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
        return std::hypot(std::min(dx, 2 - dx), std::min(dy, 2 - dy));
    };
    while (static_cast<int>(points.size()) < count) {
        Vector3 best;
        double bestGap = -1;
        for (int c = 0; c < 6; ++c) {
            const Vector3 candidate{randomBetween(-1, 1), randomBetween(-1, 1), 0};
            double nearest = 9;
            for (const Vector3& p : points)
                nearest = std::min(nearest, gap(p, candidate));
            if (nearest > bestGap) {
                bestGap = nearest;
                best = candidate;
            }
        }
        points.push_back(best);
    }
    return points;
}
}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const auto fromLight = [&](const PointLight& light) {
        std::vector<Vector3> aims(static_cast<std::size_t>(settings().shadowRayCount));
        std::generate(aims.begin(), aims.end(), [&] {
            return light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
        });
        const double open = std::transform_reduce(
            aims.begin(), aims.end(), 0.0, std::plus<>{}, [&](const Vector3& aim) {
                const Vector3 start = P + N * kShadowBias;
                const auto hit = scene.findClosestIntersection({start, (aim - start).normalised()});
                return hit && hit->distance < (aim - start).magnitude() ? 0.0 : 1.0;
            });
        const Vector3 L = (light.position() - P).normalised();
        const ColourRGB I = light.illuminationAt((light.position() - P).magnitude());
        return open / static_cast<double>(aims.size()) *
               (object.colour() * I * (object.phongKD() * std::max(0.0, N.dot(L))) +
                light.colour() * I *
                    (object.phongKS() *
                     std::pow(std::max(0.0, L.reflectIn(N).dot((O - P).normalised())),
                              object.phongAlpha())));
    };
    return std::transform_reduce(scene.pointLights().begin(), scene.pointLights().end(),
                                 object.colour() * scene.ambientLighting(), std::plus<>{},
                                 fromLight);
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray ray = camera.castRay(x, y);
        const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        const std::vector<Vector3> lens = blueNoise(settings().dofRayCount);
        const ColourRGB sum = std::transform_reduce(
            lens.begin(), lens.end(), ColourRGB{}, std::plus<>{}, [&](const Vector3& unit) {
                const Vector3 from = unit * settings().dofAmount;
                return trace(scene, {from, (focus - from).normalised()}, settings().bounces);
            });
        image.set(x, y, sum * (1.0 / static_cast<double>(lens.size())));
    });
    return image;
}
}  // namespace raytracer
