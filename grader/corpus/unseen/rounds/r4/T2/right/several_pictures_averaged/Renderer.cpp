// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
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
        int ok = 0;
        const int want = settings().shadowRayCount;
        for (int i = 0; i < want; i++) {
            const Vector3 aim = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            // from the light to the point, so the hit must be at the point itself
            const Vector3 start = P + N * kShadowBias;
            const Vector3 back = start - aim;
            const auto hit = scene.findClosestIntersection(Ray{aim, back.normalised()});
            if (!hit || hit->distance > back.magnitude() - 1e-6) ok++;
        }
        colour += (diffuse + specular) * (double(ok) / want);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    const int w = image.width();
    const int h = image.height();
    std::vector<ColourRGB> sums(static_cast<std::size_t>(w) * h);

    // dofRayCount whole pictures, each with its own random lens points, one after the other
    std::mt19937 gen(4711);
    std::uniform_real_distribution<double> lensRange(-settings().dofAmount, settings().dofAmount);
    for (int picture = 0; picture < settings().dofRayCount; picture++) {
        for (int y = 0; y < h; y++) {
            for (int x = 0; x < w; x++) {
                const Ray ray = camera.castRay(x, y);
                const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
                const double lx = lensRange(gen);
                const double ly = lensRange(gen);
                const Vector3 lens(lx, ly, 0);
                sums[y * w + x] +=
                    trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
            }
        }
    }
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            image.set(x, y, sums[y * w + x] / settings().dofRayCount);
    return image;
}

}  // namespace raytracer
