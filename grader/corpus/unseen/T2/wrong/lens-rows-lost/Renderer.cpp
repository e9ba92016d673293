// Own threads: each gets a block of rows.
// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
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
        const Vector3 start = P + N * kShadowBias;
        int visible = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 target =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 path = target - start;
            const auto hit = scene.findClosestIntersection(Ray{start, path.normalised()});
            if (!hit || hit->distance > path.magnitude()) ++visible;
        }
        colour += (diffuse + specular) * (double(visible) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    // TASK T2.2 begin
    const Camera camera{settings()};
    Image image{settings()};
    const int numThreads = std::max(1, settings().threads);
    const int rowsPerThread = image.height() / numThreads;

    auto renderBlock = [&](int firstRow, int lastRow) {
        for (int y = firstRow; y < lastRow; y++) {
            for (int x = 0; x < image.width(); x++) {
                Ray ray = camera.castRay(x, y);
                Vector3 focal = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
                ColourRGB sum;
                for (int i = 0; i < settings().dofRayCount; i++) {
                    Vector3 origin(randomBetween(-1, 1) * settings().dofAmount,
                                   randomBetween(-1, 1) * settings().dofAmount, 0);
                    sum += trace(scene, Ray(origin, (focal - origin).normalised()),
                                 settings().bounces);
                }
                image.set(x, y, sum / settings().dofRayCount);
            }
        }
    };

    std::vector<std::thread> threads;
    for (int t = 0; t < numThreads; t++) {
        threads.emplace_back(renderBlock, t * rowsPerThread, (t + 1) * rowsPerThread);
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    return image;
    // TASK T2.2 end
}

}  // namespace raytracer
