// Samplers as policies: stratified where a square number of samples allows it.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>
#include <utility>
#include <vector>

namespace raytracer {

namespace {

template <typename S>
concept Sampler2D = requires(S s, int i, int n) { { s(i, n) } -> std::same_as<std::pair<double, double>>; };

/// Uniform in [0, 1)^2.
struct Independent {
    std::pair<double, double> operator()(int, int) const {
        const double a = randomBetween(0, 1);
        return {a, randomBetween(0, 1)};
    }
};
/// Jittered cells of the largest square grid; what is left over is independent.
struct Jittered {
    std::pair<double, double> operator()(int i, int n) const {
        const int side = static_cast<int>(std::sqrt(static_cast<double>(n)));
        if (i >= side * side) return Independent{}(i, n);
        const double a = randomBetween(i % side, i % side + 1) / side;
        return {a, randomBetween(i / side, i / side + 1) / side};
    }
};

template <Sampler2D S>
class SquareLens {
public:
    SquareLens(double half, int n) : half_(half), n_(n) {}
    [[nodiscard]] Vector3 point(int i) const {
        const auto [a, b] = sampler_(i, n_);
        return {half_ * (2 * a - 1), half_ * (2 * b - 1), 0};
    }

private:
    S sampler_;
    double half_;
    int n_;
};

template <Sampler2D S>
class BallLight {
public:
    BallLight(const Vector3& centre, double radius, int n) : centre_(centre), radius_(radius), n_(n) {}
    [[nodiscard]] Vector3 point(int i) const {
        const auto [a, b] = sampler_(i, n_);
        const double z = 2 * a - 1, s = std::sqrt(1 - z * z), t = 2 * std::numbers::pi * b;
        return centre_ + Vector3{s * std::cos(t), s * std::sin(t), z} * (radius_ * std::cbrt(randomBetween(0, 1)));
    }

private:
    S sampler_;
    Vector3 centre_;
    double radius_;
    int n_;
};

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
        const int n = settings().shadowRayCount;
        const BallLight<Jittered> ball{light.position(), settings().lightSize, n};
        int through = 0;
        for (int i = 0; i < n; ++i) {
            const Ray ray{P + N * kShadowBias, (ball.point(i) - P - N * kShadowBias)};
            const auto hit = scene.findClosestIntersection(ray);
            if (!hit || hit->distance >= 1.0) ++through;
        }
        colour += (diffuse + specular) * (static_cast<double>(through) / n);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const int n = settings().dofRayCount;
        const SquareLens<Jittered> lens{settings().dofAmount, n};
        const Vector3 direction = camera.castRay(x, y).direction;
        const Vector3 focus = direction * (settings().dofFocalPlane / direction.z);
        ColourRGB sum;
        for (int i = 0; i < n; ++i) {
            const Vector3 from = lens.point(i);
            sum += trace(scene, {from, (focus - from).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / n);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
