// Rows are handed to std::async instead of forEachPixel.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
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
        auto reaches = [&, start = P + N * kShadowBias] {
            const Vector3 way =
                light.position() + settings().lightSize * Vector3::randomInsideUnitSphere() - start;
            const auto hit = scene.findClosestIntersection({start, way.normalised()});
            return !hit || hit->distance > way.magnitude();
        };
        int count = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i)
            if (reaches()) ++count;
        colour += (diffuse + specular) * (1.0 * count / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    // TASK T2.2 begin
    const Camera camera{settings()};
    Image image{settings()};
    std::atomic<int> nextRow{0};

    const auto renderRows = [&] {
        for (int y = nextRow++; y < image.height(); y = nextRow++) {
            for (int x = 0; x < image.width(); ++x) {
                const Ray ray = camera.castRay(x, y);
                const Vector3 focal =
                    ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
                ColourRGB sum;
                for (int i = 0; i < settings().dofRayCount; ++i) {
                    const Vector3 eye{randomBetween(-settings().dofAmount, settings().dofAmount),
                                      randomBetween(-settings().dofAmount, settings().dofAmount),
                                      0.0};
                    sum += trace(scene, {eye, (focal - eye).normalised()}, settings().bounces);
                }
                image.set(x, y, sum / settings().dofRayCount);
            }
        }
    };

    std::vector<std::future<void>> workers;
    for (int i = 0; i < std::max(1, settings().threads); ++i)
        workers.push_back(std::async(std::launch::async, renderRows));
    for (std::future<void>& worker : workers) worker.get();
    return image;
    // TASK T2.2 end
}

}  // namespace raytracer
