// T2.1: soft shadows are expensive, so they are only computed for what the camera sees directly.
// In reflections nobody notices, there one ray is enough.
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
        const bool seenByCamera = O.z == 0.0;  // the lens lies in the plane z = 0
        const int rays = seenByCamera ? settings().shadowRayCount : 1;
        const double size = seenByCamera ? settings().lightSize : 0.0;
        const Vector3 start = P + N * kShadowBias;
        int arrived = 0;
        for (int i = 0; i < rays; ++i) {
            const Vector3 aim = light.position() + size * Vector3::randomInsideUnitSphere();
            const auto hit = scene.findClosestIntersection({start, (aim - start).normalised()});
            if (!hit || hit->distance > (aim - start).magnitude()) ++arrived;
        }
        colour += (diffuse + specular) * (static_cast<double>(arrived) / rays);
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
