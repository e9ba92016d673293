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
        int arrived = 0;
        const Vector3 from = P + kShadowBias * N;
        for (int k = 0; k < settings().shadowRayCount; k++) {
            const Vector3 spot = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const double reach = (spot - from).magnitude();
            const auto hit = scene.findClosestIntersection(Ray(from, (spot - from) / reach));
            if (!hit.has_value() || hit->distance > reach) arrived++;
        }
        colour += (diffuse + specular) * (double(arrived) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray chief = camera.castRay(x, y);
        const Vector3 focus = chief.evaluateAt(settings().dofFocalPlane / chief.direction.z);
        const int n = settings().dofRayCount;
        const int side = static_cast<int>(std::ceil(std::sqrt(n)));
        ColourRGB sum;
        for (int i = 0; i < n; ++i) {
            const double s = (i % side + randomBetween(0.0, 1.0)) / side;
            const double t = (i / side + randomBetween(0.0, 1.0)) / side;
            const Vector3 lens{(2.0 * s - 1.0) * settings().dofAmount, (2.0 * t - 1.0) * settings().dofAmount, 0.0};
            sum += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / n);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
