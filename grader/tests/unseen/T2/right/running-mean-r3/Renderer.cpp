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
        double mean = 0;
        for (int n = 1; n <= settings().shadowRayCount; ++n) {
            const Vector3 start = P + N * kShadowBias;
            const Vector3 towards = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
            const auto occ = scene.findClosestIntersection(Ray{start, towards.normalised()});
            const double v = (!occ || occ->distance >= towards.magnitude()) ? 1 : 0;
            mean += (v - mean) / n;
        }
        colour += (diffuse + specular) * mean;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray pin = camera.castRay(x, y);
        const Vector3 focal = pin.evaluateAt(settings().dofFocalPlane / pin.direction.z);
        ColourRGB mean;
        for (int n = 1; n <= settings().dofRayCount; ++n) {
            const Vector3 lens = Vector3{randomBetween(-1, 1), randomBetween(-1, 1), 0} * settings().dofAmount;
            const ColourRGB c = trace(scene, Ray{lens, (focal - lens).normalised()}, settings().bounces);
            mean += (c - mean) / n;
        }
        image.set(x, y, mean);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
