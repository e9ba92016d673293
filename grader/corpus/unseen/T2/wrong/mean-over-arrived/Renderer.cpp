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
        // TASK T2.1 begin
        const ColourRGB arriving = light.illuminationAt((light.position() - P).magnitude());
        ColourRGB direct;
        int samples = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 place =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const double distance = (place - P).magnitude();
            const Vector3 L = (place - P).normalised();
            const auto occluder = scene.findClosestIntersection(Ray{P + N * kShadowBias, L});
            if (occluder && occluder->distance < distance) continue;
            ++samples;
            direct += object.colour() * arriving * (object.phongKD() * std::max(0.0, N.dot(L)));
            direct += light.colour() * arriving * object.phongKS() *
                      std::pow(std::max(0.0, L.reflectIn(N).dot(toViewer)), object.phongAlpha());
        }
        if (samples > 0) colour += direct / samples;
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
