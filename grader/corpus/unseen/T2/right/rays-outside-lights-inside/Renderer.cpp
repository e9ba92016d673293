// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace raytracer {

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const auto& lights = scene.pointLights();

    // TASK T2.1 begin
    std::vector<int> arrived(lights.size(), 0);
    for (int ray = 0; ray < settings().shadowRayCount; ++ray) {
        std::transform(lights.begin(), lights.end(), arrived.begin(), arrived.begin(),
                       [&](const PointLight& light, int soFar) {
                           const Vector3 from = P + N * kShadowBias;
                           const Vector3 path = light.position() - from +
                                                Vector3::randomInsideUnitSphere() * settings().lightSize;
                           const auto hit = scene.findClosestIntersection({from, path.normalised()});
                           return hit && hit->distance < path.magnitude() ? soFar : soFar + 1;
                       });
    }
    // TASK T2.1 end

    const Vector3 toViewer = (O - P).normalised();
    return std::transform_reduce(
        lights.begin(), lights.end(), arrived.begin(), object.colour() * scene.ambientLighting(),
        [](const ColourRGB& a, const ColourRGB& b) { return a + b; },
        [&](const PointLight& light, int count) {
            const Vector3 offset = light.position() - P;
            const Vector3 toLight = offset.normalised();
            const ColourRGB arriving = light.illuminationAt(offset.magnitude()) *
                                       (count / static_cast<double>(settings().shadowRayCount));
            const double facing = std::max(0.0, N.dot(toLight));
            const double mirrored = std::max(0.0, toLight.reflectIn(N).dot(toViewer));
            return object.colour() * arriving * (object.phongKD() * facing) +
                   light.colour() * arriving *
                       (object.phongKS() * std::pow(mirrored, object.phongAlpha()));
        });
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray ray = camera.castRay(x, y);
        const Vector3 focal = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        std::vector<ColourRGB> colours(static_cast<std::size_t>(settings().dofRayCount));
        std::generate(colours.begin(), colours.end(), [&] {
            const double right = randomBetween(-settings().dofAmount, settings().dofAmount);
            const double up = randomBetween(-settings().dofAmount, settings().dofAmount);
            const Vector3 eye{right, up, 0.0};
            return trace(scene, Ray{eye, (focal - eye).normalised()}, settings().bounces);
        });
        image.set(x, y, std::accumulate(colours.begin(), colours.end(), ColourRGB{}) / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
