// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <functional>

namespace raytracer {

static int arrivals(const Scene& sc, const Vector3& from, const Vector3& light, double size, int left) {
    if (left == 0) return 0;
    Vector3 d = light + Vector3::randomInsideUnitSphere() * size - from;
    auto h = sc.findClosestIntersection(Ray{from, d.normalised()});
    return (h && h->distance < d.magnitude() ? 0 : 1) + arrivals(sc, from, light, size, left - 1);
}

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
        double share = arrivals(scene, P + N * kShadowBias, light.position(), settings().lightSize,
                                settings().shadowRayCount);
        share = share / settings().shadowRayCount;
        colour += (diffuse + specular) * share;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const auto ray = camera.castRay(x, y);
        const Vector3 f = ray.direction / ray.direction.z * settings().dofFocalPlane;
        std::function<ColourRGB(int)> total = [&](int n) -> ColourRGB {
            if (n == 0) return ColourRGB{};
            if (n > 1) return total(n / 2) + total(n - n / 2);
            const double ax = randomBetween(-settings().dofAmount, settings().dofAmount);
            const double ay = randomBetween(-settings().dofAmount, settings().dofAmount);
            const Vector3 e{ax, ay, 0};
            return trace(scene, Ray{e, (f - e).normalised()}, settings().bounces);
        };
        image.set(x, y, total(settings().dofRayCount) / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
