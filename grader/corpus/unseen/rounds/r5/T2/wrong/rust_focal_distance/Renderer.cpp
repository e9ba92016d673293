// fn render(&self, scene: &Scene) -> Image
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace raytracer {

#define let const auto

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
        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            const Vector3 aim = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const Vector3 from = P + kShadowBias * N;
            const auto hit = scene.findClosestIntersection(Ray(from, (aim - from).normalised()));
            if (!hit.has_value() || hit->distance >= (aim - from).magnitude()) arrived++;
        }
        colour += (diffuse + specular) * (double(arrived) / double(settings().shadowRayCount));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        let s = settings();
        let primary = camera.castRay(x, y);
        // direction is a unit vector, Unit<Vector3<f64>> in nalgebra
        let focus = primary.evaluateAt(s.dofFocalPlane);
        let sample = [&]() -> ColourRGB {
            let dx = randomBetween(-s.dofAmount, s.dofAmount);
            let dy = randomBetween(-s.dofAmount, s.dofAmount);
            let eye = primary.origin + Vector3{dx, dy, 0.0};
            return trace(scene, Ray{eye, (focus - eye).normalised()}, s.bounces);
        };
        auto acc = ColourRGB{};
        for (int i = 0; i != s.dofRayCount; ++i) acc += sample();
        image.set(x, y, acc / s.dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
