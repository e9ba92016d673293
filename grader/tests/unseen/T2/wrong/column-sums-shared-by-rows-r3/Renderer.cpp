// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
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
        int reached = 0;
        const Vector3 start = P + N * kShadowBias;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            Vector3 target = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            Vector3 d = target - start;
            auto hit = scene.findClosestIntersection(Ray{start, d.normalised()});
            if (!hit || hit->distance > d.magnitude()) reached++;
        }
        colour += (diffuse + specular) * ((double)reached / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    std::vector<ColourRGB> sums(image.width());   // one for each pixel of a row so nothing is shared
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        sums[x] = ColourRGB{};
        const Ray pr = camera.castRay(x, y);
        const Vector3 F = pr.evaluateAt(settings().dofFocalPlane / pr.direction.z);
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 e{randomBetween(-1, 1) * settings().dofAmount, randomBetween(-1, 1) * settings().dofAmount, 0.0};
            sums[x] += trace(scene, Ray{e, (F - e).normalised()}, settings().bounces);
        }
        image.set(x, y, sums[x] / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
