#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace raytracer {
namespace {

struct Turn {
    Vector3 a, b, c;
    Vector3 operator()(const Vector3& p) const { return a * p.x + b * p.y + c * p.z; }
};

/// A uniform rotation from a random unit quaternion (Shoemake 1992).
Turn randomTurn() {
    const double u = randomBetween(0, 1), s = randomBetween(0, 2 * std::numbers::pi), t = randomBetween(0, 2 * std::numbers::pi);
    const double x = std::sqrt(1 - u) * std::sin(s), y = std::sqrt(1 - u) * std::cos(s);
    const double z = std::sqrt(u) * std::sin(t), w = std::sqrt(u) * std::cos(t);
    return {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
            {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
            {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
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
        const Turn turn = randomTurn();
        const int count = settings().shadowRayCount;
        const Vector3 start = P + N * kShadowBias;
        double seen = 0;
        for (int i = 0; i < count; ++i) {
            // A spiral over the unit sphere, turned at random, each point at a random depth.
            const double z = 1.0 - (2.0 * i + 1.0) / count;
            const double ring = std::sqrt(1.0 - z * z);
            const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
            const Vector3 onSphere{ring * std::cos(angle), ring * std::sin(angle), z};
            const Vector3 target = light.position() + turn(onSphere) * (settings().lightSize * std::cbrt(randomBetween(0, 1)));
            const Vector3 way = target - start;
            const auto hit = scene.findClosestIntersection({start, way.normalised()});
            if (!(hit && hit->distance < way.magnitude())) seen += 1.0;
        }
        colour += (diffuse + specular) * (seen / count);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        // N rooks: one point in each column and each row of the lens.
        const int n = settings().dofRayCount;
        std::vector<int> rows(static_cast<std::size_t>(n));
        std::iota(rows.begin(), rows.end(), 0);
        for (int i = n - 1; i > 0; --i) std::swap(rows[i], rows[int(randomBetween(0, i + 1))]);
        const auto place = [&](int cell) { return settings().dofAmount * (2.0 * (cell + randomBetween(0, 1)) / n - 1.0); };
        const Ray ray = camera.castRay(x, y);
        const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        ColourRGB sum;
        for (int i = 0; i < n; ++i) {
            const Vector3 lens{place(i), place(rows[i]), 0.0};
            sum += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / n);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
