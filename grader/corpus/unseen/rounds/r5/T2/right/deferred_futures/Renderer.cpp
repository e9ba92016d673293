// Lazy evaluation: every ray is a promise.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <execution>
#include <future>
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
        const auto shadowRay = [&scene, start = P + N * kShadowBias](Vector3 aim) {
            const Vector3 way = aim - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
            return hit && hit->distance < way.magnitude() ? 0.0 : 1.0;
        };
        std::vector<std::future<double>> rays(static_cast<std::size_t>(settings().shadowRayCount));
        std::generate(rays.begin(), rays.end(), [&] {
            return std::async(std::launch::deferred, shadowRay,
                              light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize);
        });
        const double share = std::transform_reduce(rays.begin(), rays.end(), 0.0, std::plus<>{},
                                                   [](std::future<double>& ray) { return ray.get(); }) /
                             static_cast<double>(rays.size());
        colour += share * (diffuse + specular);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray axis = camera.castRay(x, y);
        const Vector3 focal = axis.evaluateAt(settings().dofFocalPlane / axis.direction.z);
        std::vector<std::future<ColourRGB>> rays;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double lx = randomBetween(-1.0, 1.0), ly = randomBetween(-1.0, 1.0);
            const Vector3 lens = settings().dofAmount * Vector3{lx, ly, 0.0};
            rays.push_back(std::async(std::launch::deferred, &Renderer::trace, this, std::cref(scene),
                                      Ray{lens, (focal - lens).normalised()}, settings().bounces));
        }
        ColourRGB sum;
        for (auto& ray : rays) sum += ray.get();
        image.set(x, y, sum / static_cast<double>(rays.size()));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
