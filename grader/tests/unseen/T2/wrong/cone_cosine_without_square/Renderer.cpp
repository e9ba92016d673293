// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

/// A direction uniform in the cone around `axis` (unit) with the given cosine of its half angle.
Vector3 uniformCone(const Vector3& axis, double cosMax) {
    const double cosTheta = 1.0 + randomBetween(0.0, 1.0) * (cosMax - 1.0);
    const double sinTheta = std::sqrt(std::max(0.0, 1.0 - cosTheta * cosTheta));
    const double phi = randomBetween(0.0, 2.0 * std::numbers::pi);
    const Vector3 a = (std::abs(axis.y) < 0.9 ? Vector3{0, 1, 0} : Vector3{1, 0, 0}).cross(axis).normalised();
    const Vector3 b = axis.cross(a);
    return a * (sinTheta * std::cos(phi)) + b * (sinTheta * std::sin(phi)) + axis * cosTheta;
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
        const Vector3 origin = P + N * kShadowBias;
        const Vector3 axis = (light.position() - origin).normalised();
        const double d = (light.position() - origin).magnitude();
        const double cosMax = std::sqrt(std::max(0.0, 1.0 - settings().lightSize / d));
        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const auto hit = scene.findClosestIntersection({origin, uniformCone(axis, cosMax)});
            if (!hit || hit->distance > d) ++arrived;
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
        const Ray central = camera.castRay(x, y);
        const double t = (settings().dofFocalPlane - central.origin.z) / central.direction.z;
        const Vector3 F = central.origin + t * central.direction;
        const auto lensRay = [&] {
            Vector3 o = central.origin;
            o.x += settings().dofAmount * randomBetween(-1, 1);
            o.y += settings().dofAmount * randomBetween(-1, 1);
            return Ray{o, (F - o).normalised()};
        };
        ColourRGB total;
        int rays = settings().dofRayCount;
        while (rays-- > 0) total += trace(scene, lensRay(), settings().bounces);
        image.set(x, y, total * (1.0 / settings().dofRayCount));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
