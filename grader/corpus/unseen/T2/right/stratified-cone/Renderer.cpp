// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

int gridSide(int atLeast) {
    int side = 1;
    while (side * side < atLeast) ++side;
    return side;
}

/// From a point outside of the ball to its near side, uniform in the solid angle.
Vector3 coneDirection(const Vector3& axis, double distance, double radius, double u, double v) {
    const double sineMax = radius / distance;
    const double cosineMax = std::sqrt(1.0 - sineMax * sineMax);
    const double cosine = 1.0 - u * (1.0 - cosineMax);
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    const Vector3 other = std::abs(axis.x) < 0.6 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
    const Vector3 right = axis.cross(other).normalised();
    const Vector3 up = axis.cross(right);
    const double turn = 2.0 * std::numbers::pi * v;
    const Vector3 unit = axis * cosine + right * (sine * std::cos(turn)) + up * (sine * std::sin(turn));
    const double across = distance * sine;
    const double inside = std::sqrt(std::max(0.0, radius * radius - across * across));
    return unit * (distance * cosine - inside);
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
        const Vector3 start = P + N * kShadowBias;
        const int side = gridSide(settings().shadowRayCount);
        const double R = settings().lightSize;
        int arrived = 0;
        for (int i = 0; i < side; ++i) {
            for (int j = 0; j < side; ++j) {
                const double u = (i + randomBetween(0.0, 1.0)) / side;
                const double v = (j + randomBetween(0.0, 1.0)) / side;
                const Vector3 aim = distance > R ? P + coneDirection(toLight, distance, R, u, v)
                                                 : light.position() + Vector3::randomInsideUnitSphere() * R;
                const Vector3 way = aim - start;
                const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
                if (!hit || hit->distance > way.magnitude()) ++arrived;
            }
        }
        colour += (diffuse + specular) * (static_cast<double>(arrived) / (side * side));
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
        const int side = gridSide(settings().dofRayCount);
        ColourRGB mean;
        for (int i = 0; i < side; ++i) {
            for (int j = 0; j < side; ++j) {
                const double u = (i + randomBetween(0.0, 1.0)) / side;
                const double v = (j + randomBetween(0.0, 1.0)) / side;
                const Vector3 eye{settings().dofAmount * (2 * u - 1), settings().dofAmount * (2 * v - 1), 0};
                mean += trace(scene, Ray{eye, (focal - eye).normalised()}, settings().bounces);
            }
        }
        mean /= side * side;
        image.set(x, y, mean);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
