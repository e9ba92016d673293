// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <array>

namespace raytracer {
namespace {

constexpr int kLanes = 8;
using Lane = std::array<double, kLanes>;

/// Eight points at a time, component by component.
struct Points {
    Lane x{}, y{}, z{};
    [[nodiscard]] Vector3 at(int i) const {
        const auto k = static_cast<std::size_t>(i);
        return {x[k], y[k], z[k]};
    }
};

Points pointsInBall(const Vector3& centre, double radius) {
    Points p;
    for (std::size_t k = 0; k < kLanes; ++k) {
        const Vector3 q = Vector3::randomInsideUnitSphere();
        p.x[k] = centre.x + radius * q.x;
        p.y[k] = centre.y + radius * q.y;
        p.z[k] = centre.z + radius * q.z;
    }
    return p;
}

Points pointsInSquare(double half) {
    Points p;
    for (double& x : p.x) x = randomBetween(-half, half);
    for (double& y : p.y) y = randomBetween(-half, half);
    return p;
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
        const Vector3 origin = P + N * kShadowBias;
        int lit = 0;
        for (int first = 0; first < settings().shadowRayCount; first += kLanes) {
            const Points goals = pointsInBall(light.position(), settings().lightSize);
            const int used = std::min(kLanes, settings().shadowRayCount - first);
            for (int k = 0; k < used; ++k) {
                const Vector3 way = goals.at(k) - origin;
                const double far = way.magnitude();
                const auto hit = scene.findClosestIntersection({origin, way * (1.0 / far)});
                lit += (!hit || hit->distance >= far);
            }
        }
        colour += (diffuse + specular) * (static_cast<double>(lit) / settings().shadowRayCount);
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
        const Vector3 focus = pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
        ColourRGB sum;
        for (int first = 0; first < settings().dofRayCount; first += kLanes) {
            const Points lens = pointsInSquare(settings().dofAmount);
            const int used = std::min(kLanes, settings().dofRayCount - first);
            for (int k = 0; k < used; ++k)
                sum += trace(scene, {lens.at(k), (focus - lens.at(k)).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
