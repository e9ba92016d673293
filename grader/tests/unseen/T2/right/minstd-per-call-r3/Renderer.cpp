// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

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
        std::minstd_rand rng(1 + (unsigned)randomBetween(0, 2147480000.0));
        rng.discard(3);
        std::uniform_real_distribution<double> uni(-1, 1);
        int c = 0;
        Vector3 st = P + N * kShadowBias;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            Vector3 v;
            do { v = Vector3(uni(rng), uni(rng), uni(rng)); } while (v.dot(v) >= 1);
            Vector3 dir = light.position() + v * settings().lightSize - st;
            double len = dir.magnitude();
            auto h = scene.findClosestIntersection(Ray(st, dir.normalised()));
            if (h && h->distance < len) c++;    // c = BLOCKED
        }
        colour += (diffuse + specular) * (1.0 - (double)c / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        std::minstd_rand rng(1 + (unsigned)randomBetween(0, 2147480000.0));
        rng.discard(3);
        std::uniform_real_distribution<double> uni(-settings().dofAmount, settings().dofAmount);
        Ray r0 = camera.castRay(x, y);
        Vector3 fp = r0.evaluateAt(settings().dofFocalPlane / r0.direction.z);
        ColourRGB acc;
        for (int i = 0; i < settings().dofRayCount; i++) {
            const double px = uni(rng), py = uni(rng);
            Vector3 p(px, py, 0);
            acc += trace(scene, Ray(p, (fp - p).normalised()), settings().bounces);
        }
        image.set(x, y, acc / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
