// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <iterator>
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
        const auto start = P + N * kShadowBias;
        std::vector<Vector3> ways;
        std::generate_n(std::back_inserter(ways), settings().shadowRayCount, [&] {
            return light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
        });
        const auto lit = std::count_if(ways.begin(), ways.end(), [&](const Vector3& w) {
            const auto hit = scene.findClosestIntersection(Ray{start, w.normalised()});
            return hit.value_or(RaycastHit{nullptr, 1e300, {}, {}}).distance > w.magnitude();
        });
        colour += (diffuse + specular) * (static_cast<double>(lit) / static_cast<double>(ways.size()));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray pinhole = camera.castRay(x, y);
        const Vector3 focal = pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
        std::vector<Ray> rays;
        std::generate_n(std::back_inserter(rays), settings().dofRayCount, [&] {
            const double a = settings().dofAmount;
            const Vector3 from{randomBetween(-a, a), randomBetween(-a, a), 0.0};
            return Ray{from, (focal - from).normalised()};
        });
        image.set(x, y, std::accumulate(rays.begin(), rays.end(), ColourRGB{}, [&](ColourRGB s, const Ray& r) {
            return s + trace(scene, r, settings().bounces) / settings().dofRayCount;
        }));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
