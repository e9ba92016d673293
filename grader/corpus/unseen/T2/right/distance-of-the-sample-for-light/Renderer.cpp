#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
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

        ColourRGB sum;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 aim = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 start = P + N * kShadowBias;
            const auto hit = scene.findClosestIntersection(Ray{start, (aim - start).normalised()});
            if (hit && hit->distance < (aim - start).magnitude()) continue;
            const double near = distance / (aim - P).magnitude();
            sum += (diffuse + specular) * (near * near);
        }
        colour += sum / settings().shadowRayCount;
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
            const Vector3 eye{settings().dofAmount * randomBetween(-1, 1), settings().dofAmount * randomBetween(-1, 1), 0};
            sum += trace(scene, Ray{eye, (focus - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
