// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
        // the light is seen under this angle
        const double angle = 2.0 * std::asin(std::min(1.0, settings().lightSize / distance));
        const Vector3 side = (std::abs(toLight.x) < 0.5 ? Vector3{1, 0, 0} : Vector3{0, 1, 0}).cross(toLight).normalised();
        const Vector3 up = toLight.cross(side);
        int reached = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const double c = 1.0 - randomBetween(0, 1) * (1.0 - std::cos(angle));
            const double r = std::sqrt(1.0 - c * c), t = randomBetween(0, 2 * std::numbers::pi);
            const Vector3 direction = toLight * c + side * (r * std::cos(t)) + up * (r * std::sin(t));
            const auto hit = scene.findClosestIntersection({P + N * kShadowBias, direction});
            if (!hit || hit->distance > distance) ++reached;
        }
        colour += (diffuse + specular) * (double(reached) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray straight = camera.castRay(x, y);
        const Vector3 aim = straight.direction * (settings().dofFocalPlane / straight.direction.z);
        ColourRGB total{0.0};
        for (int k = 0; k < settings().dofRayCount; k++) {
            Vector3 eye(settings().dofAmount * randomBetween(-1, 1),
                        settings().dofAmount * randomBetween(-1, 1), 0);
            total += trace(scene, Ray(eye, (aim - eye).normalised()), settings().bounces);
        }
        image.set(x, y, total * (1.0 / settings().dofRayCount));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
