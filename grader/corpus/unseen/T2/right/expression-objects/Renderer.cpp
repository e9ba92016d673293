// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <functional>
#include <numbers>
#include <type_traits>

namespace raytracer {
namespace {

template <std::invocable Draw>
auto mean(int n, const Draw& draw) {
    std::remove_cvref_t<std::invoke_result_t<const Draw&>> total{};
    for (int i = 0; i < n; ++i)
        total += draw();
    total /= static_cast<double>(n);
    return total;
}

struct Visibility {
    const Scene& scene;
    Vector3 start;
    const PointLight& light;
    const RenderSettings& with;

    double operator()() const {
        const Vector3 direction = Vector3::randomInsideUnitSphere().normalised();
        const Vector3 aim = light.position() + direction * randomBetween(0.0, with.lightSize);
        const double length = (aim - start).magnitude();
        const auto hit = scene.findClosestIntersection(Ray{start, (aim - start) / length});
        return hit && hit->distance < length ? 0.0 : 1.0;
    }
};

struct LensRay {
    const Renderer& renderer;
    const Scene& scene;
    const RenderSettings& with;
    Vector3 focal;

    ColourRGB operator()() const {
        const double x = with.dofAmount * (randomBetween(0.0, 1.0) - 0.5);
        const double y = with.dofAmount * (randomBetween(0.0, 1.0) - 0.5);
        const Vector3 lens{x, y, 0.0};
        return renderer.trace(scene, Ray{lens, (focal - lens).normalised()}, with.bounces);
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
        const double share = mean(settings().shadowRayCount, Visibility{scene, P + N * kShadowBias, light, settings()});
        colour += share * (diffuse + specular);
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
        image.set(x, y, mean(settings().dofRayCount, LensRay{*this, scene, settings(), ray.evaluateAt(settings().dofFocalPlane / ray.direction.z)}));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
