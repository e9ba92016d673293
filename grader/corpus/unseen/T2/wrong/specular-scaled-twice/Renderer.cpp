#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

/// Share of the light's ball that a point sees.
double visibleShare(const Scene& scene, const Vector3& light, const Vector3& from, const RenderSettings& settings) {
    double arrived = 0.0;
    for (int i = 0; i < settings.shadowRayCount; ++i) {
        const Vector3 to = light + Vector3::randomInsideUnitSphere() * settings.lightSize;
        const double length = (to - from).magnitude();
        const auto blocker = scene.findClosestIntersection({from, (to - from) / length});
        const bool blocked = blocker.has_value() && blocker->distance < length;
        arrived += blocked ? 0.0 : 1.0;
    }
    return arrived / settings.shadowRayCount;
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
        const double share = visibleShare(scene, light.position(), P + N * kShadowBias, settings());
        const ColourRGB highlight = specular * share;
        colour += (diffuse + highlight) * share;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray middle = camera.castRay(x, y);
        const double t = settings().dofFocalPlane / middle.direction.z;
        const Vector3 focus = middle.evaluateAt(t);
        const double a = settings().dofAmount;
        ColourRGB total{0.0};
        for (int i = 0; i < settings().dofRayCount; i++) {
            Vector3 eye;
            eye.x = randomBetween(-a, a);
            eye.y = randomBetween(-a, a);
            total += trace(scene, Ray{eye, (focus - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, total / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
