// Sampling the cone subtended by the spherical light, after PBRT 12.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {
void coordinateSystem(const Vector3& a, Vector3& b, Vector3& c) {
    b = (std::abs(a.x) > std::abs(a.y) ? Vector3{-a.z, 0, a.x} : Vector3{0, a.z, -a.y}).normalised();
    c = a.cross(b);
}
Vector3 sampleCone(const Vector3& axis, double cosThetaMax) {
    const double cosTheta = std::lerp(1.0, cosThetaMax, randomBetween(0, 1));
    const double sinTheta = std::sqrt(std::max(0.0, 1 - cosTheta * cosTheta));
    const double phi = randomBetween(0, 2 * std::numbers::pi);
    Vector3 b, c;
    coordinateSystem(axis, b, c);
    return b * (std::cos(phi) * sinTheta) + c * (std::sin(phi) * sinTheta) + axis * cosTheta;
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
        const double sinThetaMax = std::min(1.0, settings().lightSize / distance);
        const double cosThetaMax = std::max(0.0, 1.0 - sinThetaMax);
        int reached = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 direction = sampleCone(toLight, cosThetaMax);
            const auto hit = scene.findClosestIntersection(Ray{P + N * kShadowBias, direction});
            if (!hit || hit->distance > distance) ++reached;
        }
        colour += (diffuse + specular) * (static_cast<double>(reached) / settings().shadowRayCount);
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
        ColourRGB total;
        for (int i = 0; i < settings().dofRayCount; i++) {
            const double a = settings().dofAmount;
            const Vector3 eye(randomBetween(-1, 1) * a, randomBetween(-1, 1) * a, 0);
            total += trace(scene, Ray(eye, (focus - eye).normalised()), settings().bounces);
        }
        image.set(x, y, total / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
