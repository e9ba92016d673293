// Option 2, tasks T2.1 and T2.2.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <future>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <ranges>
#include <utility>
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
        // Backwards: from the light to the point. Blocked where something stops the ray early.
        const Vector3 goal = P + N * kShadowBias;
        int n = 0;
        for (int i = 0; i != settings().shadowRayCount; ++i) {
            const Vector3 lamp = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 way = goal - lamp;
            const double length = way.magnitude();
            const auto hit = scene.findClosestIntersection(Ray{lamp, way / length});
            if (!hit || hit->distance >= length) n++;
        }
        colour += (diffuse + specular) * (n * 1.0 / settings().shadowRayCount);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // Moving the eye by (a, b) while the focal plane stays put is a shear of the world:
        // x' = x + a (1 - z / F). Points carry w = 1, directions w = 0.
        const Vector3 d = camera.castRay(x, y).direction;
        const double F = settings().dofFocalPlane;
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double a = settings().dofAmount * randomBetween(-1.0, 1.0);
            const double b = settings().dofAmount * randomBetween(-1.0, 1.0);
            const double M[3][4] = {{1, 0, -a / F, a}, {0, 1, -b / F, b}, {0, 0, 1, 0}};
            const auto transform = [&M](const Vector3& v, double w) {
                const auto row = [&](const double* m) { return m[0] * v.x + m[1] * v.y + m[2] * v.z + m[3] * w; };
                return Vector3{row(M[0]), row(M[1]), row(M[2])};
            };
            sum += trace(scene, Ray{transform({}, 1.0), transform(d, 0.0).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
