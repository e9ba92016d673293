// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace raytracer {

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 toViewer = (O - P).normalised();
    ColourRGB colour = object.colour() * scene.ambientLighting();

    // What one point of a light gives, were nothing in the way.
    const auto phong = [&](const PointLight& light, const Vector3& source) {
        const Vector3 way = source - P;
        const Vector3 L = way.normalised();
        const ColourRGB arriving = light.illuminationAt(way.magnitude());
        const double facing = std::max(0.0, N.dot(L));
        const double mirrored = std::max(0.0, L.reflectIn(N).dot(toViewer));
        return object.colour() * arriving * (object.phongKD() * facing) +
               light.colour() * arriving * (object.phongKS() * std::pow(mirrored, object.phongAlpha()));
    };

    for (const PointLight& light : scene.pointLights()) {
        // TASK T2.1 begin
        ColourRGB sum;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 source = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 start = P + N * kShadowBias;
            const Ray shadowRay{start, (source - start).normalised()};
            const auto occluder = scene.findClosestIntersection(shadowRay);
            if (!occluder || occluder->distance > (source - start).magnitude()) sum += phong(light, source);
        }
        colour += sum / settings().shadowRayCount;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const auto [f, a, n, depth] = std::tuple{settings().dofFocalPlane, settings().dofAmount,
                                                 settings().dofRayCount, settings().bounces};
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 meeting{d.x / d.z * f, d.y / d.z * f, f};
        ColourRGB mean;
        for (int k = 1; k <= n; ++k) {
            const double lensX = randomBetween(-a, a);
            const double lensY = randomBetween(-a, a);
            const Vector3 lens{lensX, lensY, 0.0};
            const ColourRGB sample = trace(scene, {lens, (meeting - lens).normalised()}, depth);
            mean += (sample - mean) / k;
        }
        image.set(x, y, mean);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
