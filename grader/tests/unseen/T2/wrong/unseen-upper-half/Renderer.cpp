#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace raytracer {
namespace {
struct Found {
    double t = std::numeric_limits<double>::infinity();
    const SceneObject* object = nullptr;
};
// Everything by hand: no call of findClosestIntersection, so that I know what happens.
Found nearest(const Scene& scene, const Ray& ray) {
    Found found;
    for (const auto& object : scene.objects())
        if (const auto hit = object->intersectionWith(ray); hit && hit->distance < found.t)
            found = {hit->distance, object.get()};
    return found;
}
bool open(const Scene& scene, const Vector3& from, const Vector3& to) {
    return nearest(scene, {from, to - from}).t >= 1.0;
}
Vector3 ball() {
    Vector3 p;
    do
        p = {randomBetween(-1, 1), randomBetween(-1, 1), randomBetween(-1, 1)};
    while (p.dot(p) > 1.0);
    return p;
}
}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 V = (O - P).normalised();
    const Vector3 from = P + N * kShadowBias;
    const int n = settings().shadowRayCount;
    const double size = settings().lightSize;
    ColourRGB colour = object.colour() * scene.ambientLighting();
    for (const PointLight& light : scene.pointLights()) {
        const double distance = (light.position() - P).magnitude();
        const Vector3 L = (light.position() - P) / distance;
        const ColourRGB I = light.illuminationAt(distance);
        const ColourRGB diffuse =
            object.colour() * I * (object.phongKD() * std::max(0.0, N.dot(L)));
        const ColourRGB specular =
            light.colour() * I *
            (object.phongKS() *
             std::pow(std::max(0.0, L.reflectIn(N).dot(V)), object.phongAlpha()));
        int seen = 0;
        for (int i = 0; i < n; ++i) {
            Vector3 o = ball();
            o.y = std::abs(o.y);
            if (open(scene, from, light.position() + o * size)) ++seen;
        }
        colour += (diffuse + specular) * (static_cast<double>(seen) / n);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    const auto follow = [&](const auto& self, const Ray& ray, int left) -> ColourRGB {
        const Found found = nearest(scene, ray);
        if (found.object == nullptr) return kBackgroundColour;
        const Vector3 at = ray.evaluateAt(found.t);
        const Vector3 normal = found.object->getNormalAt(at);
        const ColourRGB direct = illuminate(scene, *found.object, at, normal, ray.origin);
        const double share = found.object->reflectivity();
        if (left == 0 || share <= 0.0) return direct;
        const Ray mirrored{at + normal * kShadowBias, (-ray.direction).reflectIn(normal)};
        return direct * (1.0 - share) + self(self, mirrored, left - 1) * share;
    };
    forEachPixel(image, [&](int x, int y) {
        const double a = settings().dofAmount;
        const int n = settings().dofRayCount;
        const Ray pinhole = camera.castRay(x, y);
        const Vector3 focus = pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
        ColourRGB sum;
        for (int i = 0; i < n; ++i) {
            const Vector3 lens{randomBetween(-a, a), randomBetween(-a, a), 0.0};
            sum += follow(follow, Ray{lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / n);
    });
    return image;
}
}  // namespace raytracer
