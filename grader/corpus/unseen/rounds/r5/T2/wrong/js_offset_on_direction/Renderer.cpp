// ported from illuminate.js and render.js
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace raytracer {

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
        const auto jitter = [&] {
            const auto v = Vector3::randomInsideUnitSphere() * settings().lightSize;
            return v;
        };
        std::vector<bool> results;
        for (auto i = 0; i < settings().shadowRayCount; i++) {
            const auto dir = (toLight + jitter()).normalised();
            const auto hit = scene.findClosestIntersection(Ray(P + N * kShadowBias, dir));
            results.push_back(!(hit && hit->distance < distance));
        }
        const auto ok = std::count(results.begin(), results.end(), true);
        colour += (diffuse + specular) * (1.0 * ok / results.size());
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const auto c = camera.castRay(x, y).direction;
        const auto focus = c * (settings().dofFocalPlane / c.z);
        auto sum = ColourRGB();
        for (auto i = settings().dofRayCount; i > 0; i--) {
            const auto ox = settings().dofAmount * randomBetween(-1, 1), oy = settings().dofAmount * randomBetween(-1, 1);
            const auto lens = Vector3(ox, oy, 0);
            // depth counts from 1 over there
            sum += trace(scene, Ray(lens, (focus - lens).normalised()), settings().bounces - 1);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
