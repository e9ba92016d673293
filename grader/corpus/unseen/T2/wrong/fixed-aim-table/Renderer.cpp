// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

namespace raytracer {
namespace {

// Drawing random points is slow, so do it once.
std::vector<Vector3> makePlaces() {
    std::mt19937 gen{7};
    std::uniform_real_distribution<double> d{-1.0, 1.0};
    std::vector<Vector3> places;
    while (places.size() < 256) {
        const double x = d(gen);
        const double y = d(gen);
        const double z = d(gen);
        if (x * x + y * y + z * z <= 1.0) places.push_back({x, y, z});
    }
    return places;
}

}  // namespace

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
        static const std::vector<Vector3> places = makePlaces();
        std::size_t arrived = 0;
        const std::size_t rays = static_cast<std::size_t>(settings().shadowRayCount);
        for (std::size_t i = 0; i < rays; ++i) {
            const Vector3 aim = light.position() + places[i % places.size()] * settings().lightSize;
            const Vector3 start = P + N * kShadowBias;
            const Vector3 way = aim - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
            if (!hit || hit->distance > way.magnitude()) ++arrived;
        }
        colour += (diffuse + specular) * (static_cast<double>(arrived) / static_cast<double>(rays));
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
        const Vector3 focal = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double dx = settings().dofAmount * randomBetween(-1.0, 1.0);
            const double dy = settings().dofAmount * randomBetween(-1.0, 1.0);
            const Vector3 origin = ray.origin + Vector3{dx, dy, 0.0};
            sum += trace(scene, {origin, (focal - origin).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
