// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>
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
        int hits = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            Vector3 target = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            Vector3 start = P + N * kShadowBias;
            double d = (target - start).magnitude();
            Ray r{start, (target - start).normalised()};
            auto hit = scene.findClosestIntersection(r);
            if (hit.has_value() && hit->distance < d) {
                hits++;
            }
        }
        double lit = 1.0 - (double)hits / settings().shadowRayCount;
        colour += diffuse * lit + specular * lit;
        // TASK T2.1 end
    }
    return colour;
}

// one thread takes every k-th row
static void renderRows(const Renderer& r, const Scene& scene, const Camera& camera, Image& image,
                       int first, int step) {
    for (int y = first; y < image.height(); y += step) {
        for (int x = 0; x < image.width(); x++) {
            Ray ray = camera.castRay(x, y);
            Vector3 F = ray.evaluateAt(r.settings().dofFocalPlane / ray.direction.z);
            ColourRGB sum;
            for (int i = 0; i < r.settings().dofRayCount; i++) {
                double a = r.settings().dofAmount;
                Vector3 E(randomBetween(-a, a), randomBetween(-a, a), 0.0);
                sum += r.trace(scene, Ray(E, (F - E).normalised()), r.settings().bounces);
            }
            image.set(x, y, sum / r.settings().dofRayCount);
        }
    }
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    const int count = 4;
    std::vector<std::thread> threads;
    for (int i = 0; i < count; i++) {
        threads.push_back(std::thread([&, i] { renderRows(*this, scene, camera, image, i, count); }));
    }
    for (auto& t : threads) t.join();
    return image;
}

}  // namespace raytracer
