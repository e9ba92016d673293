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
        const ColourRGB diffuse =
            object.colour() * arriving * (object.phongKD() * std::max(0.0, N.dot(toLight)));
        const ColourRGB specular =
            light.colour() * arriving *
            (object.phongKS() *
             std::pow(std::max(0.0, toLight.reflectIn(N).dot(toViewer)), object.phongAlpha()));
        const int n = settings().shadowRayCount;
        const Vector3 start = P + N * kShadowBias;

        int reached = 0;
        for (int i = 0; i < n; ++i) {
            const Vector3 target =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 way = target - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
            if (!hit || hit->distance > way.magnitude()) ++reached;
        }

        colour += (diffuse + specular) * (static_cast<double>(reached) / n);
    }
    return colour;
}
Image Renderer::render(const Scene& scene) const {
    struct Job {
        int x, y;
        Ray ray;
    };
    const Camera camera{settings()};
    Image image{settings()};
    std::vector<Job> jobs;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const Ray pinhole = camera.castRay(x, y);
            const Vector3 focus =
                pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
            for (int i = 0; i < settings().dofRayCount; ++i) {
                const double a = settings().dofAmount;
                const Vector3 lens{randomBetween(-a, a), randomBetween(-a, a), 0};
                jobs.push_back({x, y, Ray{lens, (focus - lens).normalised()}});
            }
        }
    for (std::size_t i = jobs.size() - 1; i > 0; --i)
        std::swap(jobs[i],
                  jobs[static_cast<std::size_t>(randomBetween(0, static_cast<double>(i) + 1))]);
    std::vector<ColourRGB> sums(static_cast<std::size_t>(image.width() * image.height()));
    for (const Job& job : jobs)
        sums[static_cast<std::size_t>(job.y * image.width() + job.x)] +=
            trace(scene, job.ray, settings().bounces);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            image.set(
                x, y,
                sums[static_cast<std::size_t>(y * image.width() + x)] / settings().dofRayCount);
    return image;
}

}  // namespace raytracer
