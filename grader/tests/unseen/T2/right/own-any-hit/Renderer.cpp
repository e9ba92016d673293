// Shadow rays do not need the CLOSEST hit, any hit before the light will do. So this asks the
// objects one by one and stops at the first, beginning with the one that blocked the ray before.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace raytracer {
namespace {

class ShadowTester {
public:
    ShadowTester(const Scene& scene, const Vector3& start) : scene_(scene), start_(start) {}

    bool blocked(const Vector3& target) {
        const Vector3 way = target - start_;
        const double length = way.magnitude();
        const Ray ray{start_, way / length};
        if (last_ != nullptr && isBefore(*last_, ray, length)) return true;
        for (const auto& object : scene_.objects()) {
            if (object.get() == last_) continue;
            if (isBefore(*object, ray, length)) {
                last_ = object.get();
                return true;
            }
        }
        return false;
    }

private:
    static bool isBefore(const SceneObject& object, const Ray& ray, double length) {
        const std::optional<RaycastHit> hit = object.intersectionWith(ray);
        return hit && hit->distance < length;
    }

    const Scene& scene_;
    Vector3 start_;
    const SceneObject* last_ = nullptr;
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
        ShadowTester tester{scene, P + N * kShadowBias};
        int blocked = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i)
            blocked += tester.blocked(light.position() +
                                      Vector3::randomInsideUnitSphere() * settings().lightSize);
        colour += (diffuse + specular) *
                  (1.0 - blocked / static_cast<double>(settings().shadowRayCount));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const auto [focal, amount, n] = std::tuple{settings().dofFocalPlane, settings().dofAmount,
                                                   settings().dofRayCount};
        const Ray through = camera.castRay(x, y);
        const Vector3 target = through.evaluateAt(focal / through.direction.z);
        ColourRGB colour;
        for (int i = 0; i < n; ++i) {
            const Vector3 lens{randomBetween(-amount, amount), randomBetween(-amount, amount), 0};
            colour += trace(scene, Ray{lens, (target - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, colour / n);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
