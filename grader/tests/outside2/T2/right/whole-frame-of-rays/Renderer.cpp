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

        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 aim = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 start = P + N * kShadowBias;
            const std::optional<RaycastHit> hit = scene.findClosestIntersection(Ray{start, (aim - start).normalised()});
            if (!hit || hit->distance > (aim - start).magnitude()) ++arrived;
        }
        colour += (diffuse + specular) * (static_cast<double>(arrived) / settings().shadowRayCount);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    struct Job { int x, y; Ray ray; };
    std::vector<Job> jobs;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            for (int i = 0; i < settings().dofRayCount; ++i) {
                const Ray m = camera.castRay(x, y);
                const Vector3 f = m.evaluateAt(settings().dofFocalPlane / m.direction.z);
                const Vector3 e{randomBetween(-1, 1) * settings().dofAmount, randomBetween(-1, 1) * settings().dofAmount, 0};
                jobs.push_back({x, y, Ray{e, (f - e).normalised()}});
            }
    std::vector<ColourRGB> sums(static_cast<std::size_t>(image.width() * image.height()));
    for (const Job& j : jobs) sums[static_cast<std::size_t>(j.y * image.width() + j.x)] += trace(scene, j.ray, settings().bounces);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) image.set(x, y, sums[static_cast<std::size_t>(y * image.width() + x)] / settings().dofRayCount);
    return image;
}

}  // namespace raytracer
