// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

/// Additive recurrence with the golden ratio, the most irrational number.
class GoldenSquare {
public:
    void next() {
        constexpr double phi = std::numbers::phi;
        x_ = wrap(x_ + 1.0 / phi);
        y_ = wrap(y_ + 1.0 / (phi * phi));
    }
    [[nodiscard]] double x() const { return 2.0 * x_ - 1.0; }
    [[nodiscard]] double y() const { return 2.0 * y_ - 1.0; }

private:
    static double wrap(double t) { return t - std::floor(t); }
    double x_ = 0.5, y_ = 0.5;
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
        ColourRGB direct;
        for (int s = 0; s < settings().shadowRayCount; ++s) {
            const Vector3 from = P + N * kShadowBias;
            const Vector3 to = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const double far = (to - from).magnitude();
            const std::optional<RaycastHit> hit = scene.findClosestIntersection(Ray{from, (to - from) / far});
            const bool lit = !hit.has_value() || hit->distance > far;
            direct += (lit ? 1.0 : 0.0) * (diffuse + specular);
        }
        colour += direct / static_cast<double>(settings().shadowRayCount);
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
        GoldenSquare square;
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            square.next();
            const Vector3 lens = Vector3{square.x(), square.y(), 0.0} * settings().dofAmount;
            sum += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
