// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <array>
#include <cstdint>
#include <utility>

namespace raytracer {
namespace {

template <std::uint32_t Base>
[[nodiscard]] constexpr double radicalInverse(std::uint32_t i) {
    double result = 0.0, digit = 1.0 / Base;
    for (; i != 0; i /= Base, digit /= Base) result += digit * (i % Base);
    return result;
}
static_assert(radicalInverse<2>(1) == 0.5 && radicalInverse<2>(3) == 0.75);

template <std::uint32_t... Bases>
class Halton {
public:
    static constexpr std::size_t kDimensions = sizeof...(Bases);
    using Sample = std::array<double, kDimensions>;

    Halton() {
        for (double& shift : shift_) shift = randomBetween(0.0, 1.0);
    }
    [[nodiscard]] Sample operator[](std::uint32_t i) const {
        return shifted({radicalInverse<Bases>(i)...}, std::make_index_sequence<kDimensions>{});
    }

private:
    template <std::size_t... I>
    [[nodiscard]] Sample shifted(const Sample& s, std::index_sequence<I...>) const {
        return {wrapped(s[I] + shift_[I])...};
    }
    static double wrapped(double x) { return x >= 1.0 ? x - 1.0 : x; }

    Sample shift_{};
};

Vector3 ballFromCube(const std::array<double, 3>& xi) {
    const double radius = std::cbrt(xi[0]);
    const double cosTheta = 2.0 * xi[1] - 1.0;
    const double sinTheta = std::sqrt(std::max(0.0, 1.0 - cosTheta * cosTheta));
    const double phi = 2.0 * std::numbers::pi * xi[2];
    return {radius * sinTheta * std::cos(phi), radius * cosTheta, radius * sinTheta * std::sin(phi)};
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
        const Halton<2, 3, 5> halton;
        const Vector3 origin = P + N * kShadowBias;
        const auto count = static_cast<std::uint32_t>(settings().shadowRayCount);
        std::uint32_t lit = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const Vector3 target = light.position() + settings().lightSize * ballFromCube(halton[i]);
            const Vector3 segment = target - origin;
            const auto hit = scene.findClosestIntersection({origin, segment.normalised()});
            if (!hit || hit->distance > segment.magnitude()) ++lit;
        }
        colour += (diffuse + specular) * (static_cast<double>(lit) / count);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Vector3 direction = camera.castRay(x, y).direction;
        const Vector3 focalPoint = direction / direction.z * settings().dofFocalPlane;
        const Halton<2, 3> halton;
        ColourRGB mean;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const auto [s, t] = halton[static_cast<std::uint32_t>(i)];
            const Vector3 lens = Vector3{2.0 * s - 1.0, 2.0 * t - 1.0, 0.0} * settings().dofAmount;
            mean += trace(scene, Ray{lens, (focalPoint - lens).normalised()}, settings().bounces) / settings().dofRayCount;
        }
        image.set(x, y, mean);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
