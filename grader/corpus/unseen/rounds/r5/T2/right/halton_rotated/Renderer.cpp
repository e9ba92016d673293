// Halton points, shifted anew (Cranley and Patterson) for every pixel and every call.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

constexpr double radicalInverse(int base, int n) {
    double result = 0.0, digit = 1.0 / base;
    for (; n > 0; n /= base, digit /= base) result += digit * (n % base);
    return result;
}

/// D low-discrepancy coordinates in [0, 1), shifted at random modulo 1.
template <int... Bases>
class Halton {
public:
    Halton() { for (double& s : shift_) s = randomBetween(0.0, 1.0); }
    std::array<double, sizeof...(Bases)> operator[](int i) const {
        std::array<double, sizeof...(Bases)> p{radicalInverse(Bases, i + 1)...};
        for (std::size_t k = 0; k < p.size(); ++k) p[k] = std::fmod(p[k] + shift_[k], 1.0);
        return p;
    }

private:
    std::array<double, sizeof...(Bases)> shift_{};
};

/// Uniform in the unit ball from three numbers in [0, 1).
Vector3 ballPoint(const std::array<double, 3>& u) {
    const double y = 1.0 - 2.0 * u[0];
    const double ring = std::sqrt(std::max(0.0, 1.0 - y * y));
    const double angle = 2.0 * std::numbers::pi * u[1];
    return std::cbrt(u[2]) * Vector3{ring * std::cos(angle), y, ring * std::sin(angle)};
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
        const Halton<2, 3, 5> sequence;
        const Vector3 start = P + N * kShadowBias;
        int open = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 way = light.position() + ballPoint(sequence[i]) * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection({start, way.normalised()});
            open += !(hit && hit->distance < way.magnitude());
        }
        colour += (diffuse + specular) * (open / static_cast<double>(settings().shadowRayCount));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Halton<2, 3> sequence;
        const Ray ray = camera.castRay(x, y);
        const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const auto [s, t] = sequence[i];
            const Vector3 eye{(2 * s - 1) * settings().dofAmount, (2 * t - 1) * settings().dofAmount, 0};
            sum += trace(scene, {eye, (focus - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
