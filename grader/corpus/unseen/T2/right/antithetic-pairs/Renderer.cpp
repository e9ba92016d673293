// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
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
        const int pairs = (settings().shadowRayCount + 1) / 2;
        const Vector3 lifted = P + N * kShadowBias;
        const auto reaches = [&](const Vector3& goal) -> int {
            const Vector3 leg = goal - lifted;
            const double length = leg.magnitude();
            const auto stop = scene.findClosestIntersection(Ray{lifted, leg / length});
            return stop && stop->distance < length ? 0 : 1;
        };
        int open = 0;
        for (int p = 0; p < pairs; ++p) {
            const Vector3 d = Vector3::randomInsideUnitSphere() * settings().lightSize;
            open += reaches(light.position() + d) + reaches(light.position() - d);
        }
        colour += (diffuse + specular) * (0.5 * open / pairs);
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
        const Vector3 sharp = chief.direction * (settings().dofFocalPlane / chief.direction.z);
        const auto through = [&](double dx, double dy) {
            const Vector3 lens{dx, dy, 0.0};
            return trace(scene, Ray{lens, (sharp - lens).normalised()}, settings().bounces);
        };
        const int pairs = (settings().dofRayCount + 1) / 2;
        const double a = 0.5 * settings().dofAmount;
        ColourRGB c;
        for (int p = 0; p < pairs; ++p) {
            const double dx = randomBetween(-a, a);
            const double dy = randomBetween(-a, a);
            c += (through(dx, dy) + through(-dx, -dy)) * 0.5;
        }
        image.set(x, y, c / pairs);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
