// Directions are left as long as they are: a shadow ray reaches its aim point at distance 1, a
// camera ray the focal plane at distance 1.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>

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

        // TASK T2.1 begin
        const Vector3 start = P + N * kShadowBias;
        unsigned arrived = 0;
        for (int i = 0; i != settings().shadowRayCount; ++i) {
            const Vector3 aim =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const auto hit = scene.findClosestIntersection(Ray{start, aim - start});
            if (hit == std::nullopt || hit->distance > 1.0) ++arrived;
        }
        colour += (diffuse + specular) * (static_cast<double>(arrived) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 focus = settings().dofFocalPlane * Vector3{d.x / d.z, d.y / d.z, 1.0};
        ColourRGB sum;
        for (int i = 0; i != settings().dofRayCount; ++i) {
            const Vector3 lens{settings().dofAmount * randomBetween(-1.0, 1.0),
                               settings().dofAmount * randomBetween(-1.0, 1.0), 0.0};
            sum += trace(scene, Ray{lens, focus - lens}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
