// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
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
        const std::size_t raysPerPoint = settings().shadowRayCount * scene.pointLights().size();
        int hitsOnLight = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 begin = P + N * kShadowBias;
            const Vector3 end = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const double length = (end - begin).magnitude();
            const auto hit = scene.findClosestIntersection(Ray{begin, (end - begin) / length});
            if (!hit || hit->distance > length) ++hitsOnLight;
        }
        colour += (diffuse + specular) * (static_cast<double>(hitsOnLight) / raysPerPoint);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray ray = camera.castRay(x, y);
        const double t = settings().dofFocalPlane / ray.direction.z;
        std::vector<ColourRGB> samples(static_cast<std::size_t>(settings().dofRayCount));
        for (ColourRGB& s : samples) {
            const double r1 = randomBetween(-1.0, 1.0) * settings().dofAmount;
            const double r2 = randomBetween(-1.0, 1.0) * settings().dofAmount;
            const Vector3 from{r1, r2, 0.0};
            s = trace(scene, Ray{from, (ray.evaluateAt(t) - from).normalised()}, settings().bounces);
        }
        const ColourRGB total = std::accumulate(samples.begin(), samples.end(), ColourRGB{});
        image.set(x, y, total / static_cast<double>(samples.size()));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
