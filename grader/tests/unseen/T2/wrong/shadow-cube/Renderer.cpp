// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

// Random point of the light
static Vector3 randomOffset(double size) {
    return Vector3{randomBetween(-size, size), randomBetween(-size, size),
                   randomBetween(-size, size)};
}

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
        double seen = 0;
        for (int n = 0; n < settings().shadowRayCount; n++) {
            Vector3 from = P + N * kShadowBias;
            Vector3 to = light.position() + randomOffset(settings().lightSize);
            auto hit = scene.findClosestIntersection({from, (to - from).normalised()});
            if (hit && hit->distance < (to - from).magnitude()) continue;
            seen++;
        }
        seen /= settings().shadowRayCount;
        colour += diffuse * seen + specular * seen;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    const RenderSettings& s = settings();
    // colour of one ray through a random point of the lens
    auto sample = [&](const Vector3& focus) {
        const Vector3 lens = s.dofAmount * Vector3{randomBetween(-1, 1), randomBetween(-1, 1), 0};
        return trace(scene, Ray{lens, (focus - lens).normalised()}, s.bounces);
    };
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray centre = camera.castRay(x, y);
        const Vector3 focus{s.dofFocalPlane * centre.direction.x / centre.direction.z,
                            s.dofFocalPlane * centre.direction.y / centre.direction.z,
                            s.dofFocalPlane};
        ColourRGB total{0, 0, 0};
        for (int i = 0; i < s.dofRayCount; i++) total += sample(focus) * (1.0 / s.dofRayCount);
        image.set(x, y, total);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
