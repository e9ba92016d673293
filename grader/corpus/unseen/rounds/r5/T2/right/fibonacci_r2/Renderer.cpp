// R2 sequence for the lens, a randomly turned Fibonacci ball for the lights.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

struct Rotation {
    Vector3 a, b, c;
    /// Uniform over all rotations: a frame from two random directions.
    static Rotation random() {
        const Vector3 a = Vector3::randomInsideUnitSphere().normalised();
        Vector3 b = Vector3::randomInsideUnitSphere();
        b = (b - a * a.dot(b)).normalised();
        return {a, b, a.cross(b)};
    }
    [[nodiscard]] Vector3 operator()(const Vector3& v) const { return a * v.x + b * v.y + c * v.z; }
};

/// The i-th of n points, spread over the ball; `offset` in [0, 1) stirs the radii.
Vector3 fibonacciBall(int i, int n, double offset) {
    const double y = 1.0 - (2.0 * i + 1.0) / n;
    const double ring = std::sqrt(1.0 - y * y);
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double radius = std::cbrt(std::fmod(offset + i * std::numbers::phi, 1.0));
    return radius * Vector3{ring * std::cos(golden * i), y, ring * std::sin(golden * i)};
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
        const int count = settings().shadowRayCount;
        const Rotation turn = Rotation::random();
        const double offset = randomBetween(0.0, 1.0);
        const Vector3 base = P + N * kShadowBias;
        double share = 0.0;
        for (int i = 0; i < count; ++i) {
            const Vector3 aim = light.position() + turn(fibonacciBall(i, count, offset)) * settings().lightSize;
            const Vector3 way = aim - base;
            const auto obstacle = scene.findClosestIntersection(Ray{base, way.normalised()});
            if (!obstacle || obstacle->distance >= way.magnitude()) share += 1.0 / count;
        }
        colour += (diffuse + specular) * share;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        constexpr double g = 1.32471795724474602596;  // g^3 = g + 1
        const double s0 = randomBetween(0.0, 1.0), t0 = randomBetween(0.0, 1.0);
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 focal = d / d.z * settings().dofFocalPlane;
        ColourRGB sum;
        for (int i = 1; i <= settings().dofRayCount; ++i) {
            const double s = std::fmod(s0 + i / g, 1.0), t = std::fmod(t0 + i / (g * g), 1.0);
            const Vector3 lens = settings().dofAmount * Vector3{2 * s - 1, 2 * t - 1, 0};
            sum += trace(scene, Ray{lens, (focal - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / static_cast<double>(settings().dofRayCount));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
