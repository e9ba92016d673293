#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

Vector3 perpendicular(const Vector3& a) {
    const Vector3 helper = std::abs(a.y) < 0.9 ? Vector3{0, 1, 0} : Vector3{1, 0, 0};
    return a.cross(helper).normalised();
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
        const Vector3 start = P + N * kShadowBias;
        const Vector3 side = perpendicular(toLight);
        const Vector3 other = toLight.cross(side);
        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const double r = settings().lightSize * std::sqrt(randomBetween(0.0, 1.0));
            const double a = randomBetween(0.0, 2.0 * std::numbers::pi);
            const Vector3 aim = light.position() + side * (r * std::cos(a)) + other * (r * std::sin(a));
            const double far = (aim - start).magnitude();
            const auto hit = scene.findClosestIntersection(Ray{start, (aim - start).normalised()});
            if (!hit.has_value() || hit->distance > far) arrived += 1;
        }
        colour += (diffuse + specular) * (static_cast<double>(arrived) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray ray = camera.castRay(x, y);
        const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        // As many cells as the next square number: at least as many rays as asked for.
        const int side = static_cast<int>(std::ceil(std::sqrt(settings().dofRayCount)));
        ColourRGB sum;
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                const double s = (column + randomBetween(0.0, 1.0)) / side;
                const double t = (row + randomBetween(0.0, 1.0)) / side;
                const Vector3 lens = settings().dofAmount * Vector3{2.0 * s - 1.0, 2.0 * t - 1.0, 0.0};
                sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
            }
        image.set(x, y, sum / (side * side));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
