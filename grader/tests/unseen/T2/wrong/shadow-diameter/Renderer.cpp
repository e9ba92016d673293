// Strong student, own sampler, but takes LIGHT_SIZE for the diameter.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

struct SphericalLight {
    Vector3 centre;
    double diameter;

    // uniform by volume
    Vector3 sample() const {
        const double z = randomBetween(-1.0, 1.0);
        const double a = randomBetween(0.0, 2.0 * std::numbers::pi);
        const double r = 0.5 * diameter * std::cbrt(randomBetween(0.0, 1.0));
        const double s = std::sqrt(1.0 - z * z);
        return centre + r * Vector3{s * std::cos(a), s * std::sin(a), z};
    }
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
        const SphericalLight bulb{light.position(), settings().lightSize};
        const Vector3 start = P + N * kShadowBias;
        double weight = 0.0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 way = bulb.sample() - start;
            const double length = way.magnitude();
            const auto hit = scene.findClosestIntersection({start, way / length});
            weight += !hit || hit->distance >= length;
        }
        colour += (diffuse + specular) * (weight / settings().shadowRayCount);
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
        const Vector3 focal = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 origin{randomBetween(-1, 1) * settings().dofAmount,
                                 randomBetween(-1, 1) * settings().dofAmount, 0};
            sum += trace(scene, Ray{origin, (focal - origin).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
