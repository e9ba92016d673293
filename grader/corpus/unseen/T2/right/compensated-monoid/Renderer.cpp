// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <functional>
#include <numeric>
#include <ranges>

namespace raytracer {

namespace {
/// A sum and what rounding has taken from it.
struct Careful {
    ColourRGB sum, lost;
    friend Careful operator+(const Careful& a, const Careful& b) {
        const ColourRGB s = a.sum + b.sum;
        const ColourRGB bb = s - a.sum;
        return {s, a.lost + b.lost + ((a.sum - (s - bb)) + (b.sum - bb))};
    }
};
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
        const auto probe = [&, start = P + N * kShadowBias](int) {
            const Vector3 step = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection({start, step.normalised()});
            return !hit || hit->distance >= step.magnitude() ? 1 : 0;
        };
        const auto range = std::views::iota(0, settings().shadowRayCount);
        const int sum = std::transform_reduce(range.begin(), range.end(), 0, std::plus<>{}, probe);
        colour += (diffuse + specular) * sum / settings().shadowRayCount;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray through = camera.castRay(x, y);
        const Vector3 focus = through.evaluateAt(settings().dofFocalPlane / through.direction.z);
        const auto shoot = [&](int) -> Careful {
            const Vector3 lens{randomBetween(-settings().dofAmount, settings().dofAmount),
                               randomBetween(-settings().dofAmount, settings().dofAmount), 0};
            return {trace(scene, {lens, (focus - lens).normalised()}, settings().bounces), {}};
        };
        const auto range = std::views::iota(0, settings().dofRayCount);
        const Careful all = std::transform_reduce(range.begin(), range.end(), Careful{}, std::plus<>{}, shoot);
        image.set(x, y, (all.sum + all.lost) / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
