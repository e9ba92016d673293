#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

/// Uniform in the unit ball.
Vector3 pointInBall() {
    const double xi = randomBetween(0.0, 1.0);
    const double radius = std::cbrt(xi);
    const double cosine = 1.0 - 2.0 * xi;
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const double azimuth = randomBetween(0.0, 2.0 * std::numbers::pi);
    return {radius * sine * std::cos(azimuth), radius * cosine, radius * sine * std::sin(azimuth)};
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
        int seen = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 to = light.position() + pointInBall() * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection({start, to.normalised()});
            seen += hit && hit->distance < to.magnitude() ? 0 : 1;
        }
        colour += (diffuse + specular) * (double(seen) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray middle = camera.castRay(x, y);
        const double t = settings().dofFocalPlane / middle.direction.z;
        const Vector3 focus = middle.evaluateAt(t);
        const double a = settings().dofAmount;
        ColourRGB total{0.0};
        for (int i = 0; i < settings().dofRayCount; i++) {
            Vector3 eye;
            eye.x = randomBetween(-a, a);
            eye.y = randomBetween(-a, a);
            total += trace(scene, Ray{eye, (focus - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, total / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
