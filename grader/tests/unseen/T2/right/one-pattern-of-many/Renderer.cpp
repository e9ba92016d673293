#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace raytracer {
namespace {
// Drawn once, used for every pixel and every point: quick, and the same picture every time.
const std::vector<Vector3>& ballPool() {
    static const std::vector<Vector3> pool = [] {
        std::mt19937 engine(1234);
        std::uniform_real_distribution<double> d(-1, 1);
        std::vector<Vector3> points;
        while (points.size() < 20011) {
            const Vector3 v{d(engine), d(engine), d(engine)};
            if (v.magnitude() <= 1) points.push_back(v);
        }
        return points;
    }();
    return pool;
}
const Vector3& nextInBall() {
    static thread_local std::size_t at = 0;
    at = (at + 1) % ballPool().size();
    return ballPool()[at];
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
        const ColourRGB diffuse =
            object.colour() * arriving * (object.phongKD() * std::max(0.0, N.dot(toLight)));
        const ColourRGB specular =
            light.colour() * arriving *
            (object.phongKS() *
             std::pow(std::max(0.0, toLight.reflectIn(N).dot(toViewer)), object.phongAlpha()));
        int shadowed = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 target = light.position() + nextInBall() * settings().lightSize;
            const Ray ray{P + N * kShadowBias, (target - (P + N * kShadowBias)).normalised()};
            const auto hit = scene.findClosestIntersection(ray);
            if (hit && hit->distance < distance) shadowed++;
        }
        colour += (diffuse + specular) * (1.0 - shadowed / double(settings().shadowRayCount));
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    std::mt19937 engine(99);
    std::uniform_real_distribution<double> side(-settings().dofAmount, settings().dofAmount);
    std::vector<Vector3> lens;
    for (int i = 0; i < settings().dofRayCount; ++i) {
        const double x = side(engine);
        lens.emplace_back(x, side(engine), 0.0);
    }
    forEachPixel(image, [&](int x, int y) {
        const Ray ray = camera.castRay(x, y);
        const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        ColourRGB sum;
        for (const Vector3& from : lens)
            sum += trace(scene, {from, (focus - from).normalised()}, settings().bounces);
        image.set(x, y, sum / static_cast<double>(lens.size()));
    });
    return image;
}
}  // namespace raytracer
