// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

constexpr double kEpsilon = 0.05;

class ShadowTester {
public:
    ShadowTester(const Scene& scene, const Vector3& point, const Vector3& normal)
        : scene_(scene), origin_(point + normal * kEpsilon) {}
    [[nodiscard]] bool lit(const Vector3& target) const {
        const Vector3 way = target - origin_;
        const auto hit = scene_.findClosestIntersection({origin_, way.normalised()});
        return !hit || hit->distance > way.magnitude();
    }

private:
    const Scene& scene_;
    Vector3 origin_;
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
        const ShadowTester tester{scene, P, N};
        int lit = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i)
            lit += tester.lit(light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize);
        colour += (diffuse + specular) * (static_cast<double>(lit) / settings().shadowRayCount);
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
