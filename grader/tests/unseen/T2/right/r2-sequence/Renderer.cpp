// Low-discrepancy points: the R2 and R3 sequences of Roberts (2018), shifted by a random vector for
// each pixel and each shaded point (Cranley and Patterson).
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <array>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace raytracer {
namespace {

template <std::size_t D>
class Roberts {
public:
    Roberts() {
        double phi = 2.0;  // x^(D+1) = x + 1
        for (int i = 0; i < 40; ++i) phi = std::pow(1.0 + phi, 1.0 / (D + 1));
        double power = 1.0;
        for (std::size_t k = 0; k < D; ++k) {
            power /= phi;
            step_[k] = power;
            at_[k] = randomBetween(0.0, 1.0);
        }
    }

    std::array<double, D> operator()() {
        for (std::size_t k = 0; k < D; ++k) {
            at_[k] += step_[k];
            at_[k] -= std::floor(at_[k]);
        }
        return at_;
    }

private:
    std::array<double, D> step_{};
    std::array<double, D> at_{};
};

Vector3 ballPoint(const std::array<double, 3>& q) {
    const double y = 2.0 * q[0] - 1.0;
    const double ring = std::sqrt(1.0 - y * y);
    const double a = 2.0 * std::numbers::pi * q[1];
    return std::cbrt(q[2]) * Vector3{ring * std::cos(a), y, ring * std::sin(a)};
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
        Roberts<3> sequence;
        const Vector3 from = P + kShadowBias * N;
        int reached = 0;
        for (int i = settings().shadowRayCount; i-- > 0;) {
            const Vector3 to = light.position() + settings().lightSize * ballPoint(sequence());
            const double far = (to - from).magnitude();
            const auto hit = scene.findClosestIntersection(Ray{from, (to - from) / far});
            if (hit && hit->distance < far) continue;
            ++reached;
        }
        colour += (diffuse + specular) * (double(reached) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray centre = camera.castRay(x, y);
        const Vector3 focus = centre.evaluateAt(settings().dofFocalPlane / centre.direction.z);
        Roberts<2> sequence;
        ColourRGB mean;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const auto [s, t] = sequence();
            const Vector3 lens = settings().dofAmount * Vector3{2 * s - 1, 2 * t - 1, 0};
            mean += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces) /
                    settings().dofRayCount;
        }
        image.set(x, y, mean);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
