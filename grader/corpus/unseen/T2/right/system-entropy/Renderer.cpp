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

static std::mt19937& rng() {
    thread_local std::mt19937 engine{std::random_device{}()};
    return engine;
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
        std::normal_distribution<double> bell;
        std::uniform_real_distribution<double> even{0.0, 1.0};
        int ok = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            Vector3 dir(bell(rng()), bell(rng()), bell(rng()));
            dir = dir.normalised() * std::pow(even(rng()), 1.0 / 3.0) * settings().lightSize;
            const Vector3 delta = light.position() + dir - P;
            const double len = delta.magnitude();
            const auto hit = scene.findClosestIntersection(Ray(P + N * kShadowBias, delta / len));
            if (!hit || hit->distance > len) ok++;
        }
        colour += (diffuse + specular) * (double(ok) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        std::uniform_real_distribution<double> lens{-settings().dofAmount, settings().dofAmount};
        const Ray r = camera.castRay(x, y);
        const Vector3 p = r.evaluateAt(settings().dofFocalPlane / r.direction.z);
        ColourRGB acc;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double lx = lens(rng()), ly = lens(rng());
            const Vector3 o(lx, ly, 0);
            acc += trace(scene, Ray(o, (p - o).normalised()), settings().bounces);
        }
        image.set(x, y, acc / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
