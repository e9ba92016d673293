// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

struct Basis {
    Vector3 u, v, w;
    explicit Basis(const Vector3& axis) : w(axis) {
        const Vector3 helper = std::abs(w.x) > 0.9 ? Vector3{0, 1, 0} : Vector3{1, 0, 0};
        u = helper.cross(w).normalised();
        v = w.cross(u);
    }
    [[nodiscard]] Vector3 operator()(double a, double b, double c) const { return u * a + v * b + w * c; }
};

/// Directions uniform over the cone in which a ball is seen (PBRT, "Sampling Spheres").
class BallSeenFrom {
public:
    BallSeenFrom(const Vector3& from, const Vector3& centre, double radius)
        : radius2_(radius * radius), distance_((centre - from).magnitude()), basis_((centre - from) / distance_),
          oneMinusCosMax_(1.0 - std::sqrt(std::max(0.0, 1.0 - radius2_ / (distance_ * distance_)))) {}

    struct Sample {
        Vector3 direction;
        double distance;  // to the near side of the ball
    };
    [[nodiscard]] Sample draw() const {
        const double cosTheta = 1.0 - randomBetween(0.0, 1.0) * oneMinusCosMax_;
        const double sin2 = std::max(0.0, 1.0 - cosTheta * cosTheta);
        const double sinTheta = std::sqrt(sin2);
        const double phi = randomBetween(0.0, 2.0 * std::numbers::pi);
        const double inside = std::sqrt(std::max(0.0, radius2_ - distance_ * distance_ * sin2));
        return {basis_(sinTheta * std::cos(phi), sinTheta * std::sin(phi), cosTheta), distance_ * cosTheta - inside};
    }
    [[nodiscard]] bool isInside() const { return distance_ * distance_ <= radius2_; }

private:
    double radius2_, distance_;
    Basis basis_;
    double oneMinusCosMax_;
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
        const Vector3 from = P + N * kShadowBias;
        const BallSeenFrom ball{from, light.position(), settings().lightSize};
        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            Vector3 direction;
            double far = 0.0;
            if (ball.isInside()) {
                const Vector3 way = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - from;
                far = way.magnitude();
                direction = way / far;
            } else {
                const auto sample = ball.draw();
                direction = sample.direction;
                far = sample.distance;
            }
            const auto hit = scene.findClosestIntersection({from, direction});
            if (!hit || hit->distance > far) ++arrived;
        }
        colour += (diffuse + specular) * (arrived / static_cast<double>(settings().shadowRayCount));
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
        for (int i = 0; i < settings().dofRayCount; i++) {
            const Vector3 eye{settings().dofAmount * randomBetween(-1.0, 1.0),
                              settings().dofAmount * randomBetween(-1.0, 1.0), 0.0};
            sum += trace(scene, Ray{eye, (focus - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
