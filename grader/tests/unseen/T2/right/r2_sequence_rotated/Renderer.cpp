// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

double fract(double x) { return x - std::floor(x); }

/// Roberts' R_d sequences with a random shift (Cranley-Patterson rotation), so that no two pixels
/// or points share a pattern.
class R2 {
public:
    R2() : x_(randomBetween(0, 1)), y_(randomBetween(0, 1)) {}
    struct Sample { double x, y; };
    Sample next() {
        constexpr double g = 1.32471795724474602596;  // x^3 = x + 1
        x_ = fract(x_ + 1.0 / g);
        y_ = fract(y_ + 1.0 / (g * g));
        return {2.0 * x_ - 1.0, 2.0 * y_ - 1.0};
    }

private:
    double x_, y_;
};

class R3Ball {
public:
    R3Ball() : a_(randomBetween(0, 1)), b_(randomBetween(0, 1)), c_(randomBetween(0, 1)) {}
    Vector3 next() {
        constexpr double g = 1.22074408460575947536;  // x^4 = x + 1
        a_ = fract(a_ + 1.0 / g);
        b_ = fract(b_ + 1.0 / (g * g));
        c_ = fract(c_ + 1.0 / (g * g * g));
        const double r = std::cbrt(a_);
        const double z = 1.0 - 2.0 * b_;
        const double s = std::sqrt(1.0 - z * z);
        const double phi = 2.0 * std::numbers::pi * c_;
        return Vector3{s * std::cos(phi), s * std::sin(phi), z} * r;
    }

private:
    double a_, b_, c_;
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
        R3Ball ball;
        const Vector3 start = P + N * kShadowBias;
        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 way = light.position() + ball.next() * settings().lightSize - start;
            const double length = way.magnitude();
            const auto hit = scene.findClosestIntersection({start, way / length});
            arrived += !hit || hit->distance > length ? 1 : 0;
        }
        colour += (diffuse + specular) * (double(arrived) / settings().shadowRayCount);
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
        const Vector3 focus = pinhole.direction * (settings().dofFocalPlane / pinhole.direction.z);
        R2 lens;
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const auto [sx, sy] = lens.next();
            const Vector3 from{sx * settings().dofAmount, sy * settings().dofAmount, 0.0};
            sum += trace(scene, {from, (focus - from).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
