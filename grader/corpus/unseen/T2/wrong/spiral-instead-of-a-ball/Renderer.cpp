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
        const double pi = std::numbers::pi;
        const Vector3 start = P + N * kShadowBias;
        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const double xi = randomBetween(0.0, 1.0);
            const double theta = std::acos(2.0 * xi - 1.0);
            const double phi = 2.0 * pi * xi;
            const double r = settings().lightSize * std::cbrt(randomBetween(0.0, 1.0));
            const Vector3 target = light.position() + r * Vector3{std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
            const Vector3 to = target - start;
            const auto hit = scene.findClosestIntersection({start, to.normalised()});
            if (!hit || hit->distance > to.magnitude()) ++arrived;
        }
        colour += (diffuse + specular) * (static_cast<double>(arrived) / settings().shadowRayCount);
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
        const Vector3 sharp = middle.direction * (settings().dofFocalPlane / middle.direction.z);
        const double a = settings().dofAmount;
        ColourRGB total;
        for (int k = 0; k < settings().dofRayCount; k++) {
            const double lx = randomBetween(-a, a);
            const double ly = randomBetween(-a, a);
            const Vector3 eye(lx, ly, 0);
            total += trace(scene, Ray(eye, (sharp - eye).normalised()), settings().bounces);
        }
        image.set(x, y, total / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
