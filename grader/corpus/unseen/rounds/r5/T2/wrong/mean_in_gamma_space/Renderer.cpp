// Perceptual average: eyes do not see linear light.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {
// Value semantics for display-referred colours.
class Perceptual {
public:
    Perceptual() = default;
    explicit Perceptual(const ColourRGB& c) : v_{encode(c.r), encode(c.g), encode(c.b)} {}
    Perceptual& operator+=(const Perceptual& o) {
        for (int i = 0; i < 3; ++i) v_[i] += o.v_[i];
        return *this;
    }
    [[nodiscard]] ColourRGB linear(double n) const { return {decode(v_[0] / n), decode(v_[1] / n), decode(v_[2] / n)}; }

private:
    static double encode(double x) { return std::pow(std::max(0.0, x), 1.0 / 2.2); }
    static double decode(double x) { return std::pow(x, 2.2); }
    std::array<double, 3> v_{};
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
        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            const Vector3 aim = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const Vector3 from = P + kShadowBias * N;
            const auto hit = scene.findClosestIntersection(Ray(from, (aim - from).normalised()));
            if (!hit.has_value() || hit->distance >= (aim - from).magnitude()) arrived++;
        }
        colour += (diffuse + specular) * (double(arrived) / double(settings().shadowRayCount));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 focus = d * (settings().dofFocalPlane / d.z);
        Perceptual sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double u = randomBetween(-1, 1), v = randomBetween(-1, 1);
            const Vector3 lens = Vector3{u, v, 0} * settings().dofAmount;
            sum += Perceptual{trace(scene, {lens, (focus - lens).normalised()}, settings().bounces)};
        }
        image.set(x, y, sum.linear(settings().dofRayCount));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
