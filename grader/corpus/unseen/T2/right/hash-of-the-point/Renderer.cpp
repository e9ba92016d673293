// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <bit>
#include <cstdint>
namespace raytracer {

namespace own {
template <typename T> struct Vec {
    T e[3];
    friend Vec operator-(Vec a, Vec b) { return {{a.e[0] - b.e[0], a.e[1] - b.e[1], a.e[2] - b.e[2]}}; }
    friend Vec operator+(Vec a, Vec b) { return {{a.e[0] + b.e[0], a.e[1] + b.e[1], a.e[2] + b.e[2]}}; }
    friend Vec operator*(T s, Vec a) { return {{s * a.e[0], s * a.e[1], s * a.e[2]}}; }
    friend T operator|(Vec a, Vec b) { return a.e[0] * b.e[0] + a.e[1] * b.e[1] + a.e[2] * b.e[2]; }
};
using V = Vec<double>;
inline V from(const Vector3& v) { return {{v.x, v.y, v.z}}; }

// Is the open segment from a to b cut by the object?
inline bool cuts(const SceneObject& thing, V a, V b) {
    const V d = b - a;
    if (const auto* s = dynamic_cast<const Sphere*>(&thing)) {
        const V m = a - from(s->centre());
        const double A = d | d, B = 2 * (m | d), C = (m | m) - s->radius() * s->radius();
        const double D = B * B - 4 * A * C;
        if (D < 0) return false;
        const double t1 = (-B - std::sqrt(D)) / (2 * A), t2 = (-B + std::sqrt(D)) / (2 * A);
        return (t1 > 0 && t1 < 1) || (t2 > 0 && t2 < 1);
    }
    if (const auto* p = dynamic_cast<const Plane*>(&thing)) {
        const V n = from(p->normal());
        const double below = d | n;
        if (below == 0) return false;
        const double t = ((from(p->point()) - a) | n) / below;
        return t > 0 && t < 1;
    }
    return false;
}
inline bool sees(const Scene& scene, V a, V b) {
    for (const auto& thing : scene.objects())
        if (cuts(*thing, a, b)) return false;
    return true;
}
}  // namespace own

namespace {
// As on a graphics card: no state, a number for every key.
std::uint64_t mix(std::uint64_t h) { h ^= h >> 30; h *= 0xbf58476d1ce4e5b9ULL; h ^= h >> 27; h *= 0x94d049bb133111ebULL; return h ^ (h >> 31); }
struct Stream {
    std::uint64_t key;
    double next() { key += 0x9e3779b97f4a7c15ULL; return static_cast<double>(mix(key) >> 11) * 0x1p-53; }
};
Stream streamAt(const Vector3& p) { return {mix(std::bit_cast<std::uint64_t>(p.x)) ^ mix(std::bit_cast<std::uint64_t>(p.y) + 1) * 3 ^ mix(std::bit_cast<std::uint64_t>(p.z) + 2) * 5}; }
}

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
        Stream stream = streamAt(P + light.position());

        const own::V here = own::from(P + N * kShadowBias);
        int seen = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 r = [&] { const double a = stream.next(), b = stream.next(), c = stream.next(); const double cz = 2 * b - 1, sz = std::sqrt(1 - cz * cz), q = std::cbrt(c), t = 2 * std::numbers::pi * a; return Vector3{q * sz * std::cos(t), q * sz * std::sin(t), q * cz}; }();
            seen += own::sees(scene, here, own::from(light.position()) + settings().lightSize * own::from(r));
        }
        const double f = double(seen) / settings().shadowRayCount;
        colour += (diffuse + specular) * f;
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
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens{settings().dofAmount * randomBetween(-1, 1),
                               settings().dofAmount * randomBetween(-1, 1), 0.0};
            sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
