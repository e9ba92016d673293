#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <cstdlib>
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

        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const double a = (rand() % 360) * std::numbers::pi / 180, z = (rand() % 201 - 100) / 100.0, q = std::sqrt(1 - z * z);
            const Vector3 rnd = Vector3(q * std::cos(a), q * std::sin(a), z);
            const Vector3 aim = light.position() + rnd * settings().lightSize;
            const Vector3 start = P + N * kShadowBias;
            const std::optional<RaycastHit> hit = scene.findClosestIntersection(Ray{start, (aim - start).normalised()});
            if (!hit || hit->distance > (aim - start).magnitude()) ++arrived;
        }
        colour += (diffuse + specular) * (static_cast<double>(arrived) / settings().shadowRayCount);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray middle = camera.castRay(x, y);
        const Vector3 focus = middle.evaluateAt(settings().dofFocalPlane / middle.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 eye{settings().dofAmount * ((rand() % 101 - 50) / 50.0), settings().dofAmount * ((rand() % 101 - 50) / 50.0), 0};
            sum += trace(scene, Ray{eye, (focus - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
