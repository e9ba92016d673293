// Phong for each shadow ray, in a float vector class of my own.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

template <typename T>
struct V3 {
    T x{}, y{}, z{};
    V3() = default;
    V3(T a, T b, T c) : x(a), y(b), z(c) {}
    explicit V3(const Vector3& v) : x(T(v.x)), y(T(v.y)), z(T(v.z)) {}
    friend V3 operator-(V3 a, V3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend V3 operator+(V3 a, V3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend V3 operator*(T s, V3 a) { return {s * a.x, s * a.y, s * a.z}; }
    friend T operator|(V3 a, V3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    [[nodiscard]] V3 unit() const { return (T(1) / std::sqrt(*this | *this)) * *this; }
};
using F3 = V3<float>;

}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const F3 n{N};
    const F3 eye = F3{O - P}.unit();
    ColourRGB colour = object.colour() * scene.ambientLighting();
    for (const PointLight& light : scene.pointLights()) {
        const ColourRGB arriving = light.illuminationAt((light.position() - P).magnitude());
        // TASK T2.1 begin
        float diffuse = 0.0F, specular = 0.0F;
        const Vector3 start = P + N * kShadowBias;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 way =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
            if (hit && hit->distance < way.magnitude()) continue;
            const F3 l = F3{way}.unit();
            const float cosine = l | n;
            const F3 r = (2 * cosine) * n - l;
            diffuse += std::max(0.0F, cosine);
            specular += std::pow(std::max(0.0F, r | eye), static_cast<float>(object.phongAlpha()));
        }
        const double share = 1.0 / settings().shadowRayCount;
        colour += object.colour() * arriving * (object.phongKD() * diffuse * share);
        colour += light.colour() * arriving * (object.phongKS() * specular * share);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        // Shear instead of aim: every lens point sees the focal plane where the pinhole does.
        const Vector3 d = camera.castRay(x, y).direction;
        const double tx = d.x / d.z, ty = d.y / d.z;
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double lx = settings().dofAmount * randomBetween(-1, 1);
            const double ly = settings().dofAmount * randomBetween(-1, 1);
            const Vector3 slope{tx - lx / settings().dofFocalPlane, ty - ly / settings().dofFocalPlane, 1.0};
            sum += trace(scene, Ray{{lx, ly, 0.0}, slope.normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
