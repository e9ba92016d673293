#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <cmath>

namespace raytracer {
namespace {
struct F3 {
    float x, y, z;
    explicit F3(const Vector3& v)
        : x(static_cast<float>(v.x)), y(static_cast<float>(v.y)), z(static_cast<float>(v.z)) {}
    F3(float a, float b, float c) : x(a), y(b), z(c) {}
    F3 operator-(F3 o) const { return {x - o.x, y - o.y, z - o.z}; }
    F3 operator+(F3 o) const { return {x + o.x, y + o.y, z + o.z}; }
    F3 operator*(float s) const { return {x * s, y * s, z * s}; }
    float dot(F3 o) const { return x * o.x + y * o.y + z * o.z; }
    float length() const { return std::sqrt(dot(*this)); }
    F3 unit() const { return *this * (1.0f / length()); }
    operator Vector3() const { return {x, y, z}; }
};
// On the surface of the lamp: it is a glowing ball.
F3 onSphere() {
    const float z = static_cast<float>(randomBetween(-1, 1));
    const float a = static_cast<float>(randomBetween(0, 6.283185307179586));
    const float s = std::sqrt(1.0f - z * z);
    return {s * std::cos(a), s * std::sin(a), z};
}
}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const F3 p(P), n(N), v = (F3(O) - p).unit();
    ColourRGB colour = object.colour() * scene.ambientLighting();
    for (const PointLight& light : scene.pointLights()) {
        const F3 c(light.position());
        const float d = (c - p).length();
        int seen = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const F3 s = c + onSphere() * static_cast<float>(settings().lightSize);
            const F3 start = p + n * 1e-3f;
            const auto hit = scene.findClosestIntersection({start, (s - start).unit()});
            if (!hit || static_cast<float>(hit->distance) > (s - start).length()) ++seen;
        }
        const F3 l = (c - p).unit();
        const float nl = std::max(0.0f, n.dot(l));
        const F3 r = n * (2.0f * n.dot(l)) - l;
        const float rv =
            std::pow(std::max(0.0f, r.dot(v)), static_cast<float>(object.phongAlpha()));
        const ColourRGB I = light.illuminationAt(d);
        const float share =
            static_cast<float>(seen) / static_cast<float>(settings().shadowRayCount);
        colour += object.colour() * I * (object.phongKD() * nl * share);
        colour += light.colour() * I * (object.phongKS() * rv * share);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const F3 d(camera.castRay(x, y).direction);
        const float f = static_cast<float>(settings().dofFocalPlane);
        const F3 focus = d * (f / d.z);
        const float a = static_cast<float>(settings().dofAmount);
        float r = 0, g = 0, b = 0;
        const int n = settings().dofRayCount;
        for (int i = 0; i < n; ++i) {
            const F3 lens(static_cast<float>(randomBetween(-1, 1)) * a,
                          static_cast<float>(randomBetween(-1, 1)) * a, 0.0f);
            const ColourRGB c = trace(scene, {lens, (focus - lens).unit()}, settings().bounces);
            r += static_cast<float>(c.r);
            g += static_cast<float>(c.g);
            b += static_cast<float>(c.b);
        }
        const float inv = 1.0f / static_cast<float>(n);
        image.set(x, y, {r * inv, g * inv, b * inv});
    });
    return image;
}
}  // namespace raytracer
