// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
        const auto isLit = [&]() -> bool {
            const Vector3 offset = Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 start = P + toLight * kShadowBias;
            const Vector3 way = light.position() + offset - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way});  // in lengths of `way`
            return !hit || hit->distance > 1.0;
        };
        int lit = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) lit += isLit() ? 1 : 0;
        const double share = lit / double(settings().shadowRayCount);
        colour += share * (diffuse + specular);
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
        Vector3 focal = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        if (const auto hit = scene.findClosestIntersection(ray)) focal = hit->location;
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double dx = settings().dofAmount * randomBetween(-1.0, 1.0);
            const double dy = settings().dofAmount * randomBetween(-1.0, 1.0);
            const Vector3 from{dx, dy, 0.0};
            sum += trace(scene, Ray{from, (focal - from).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
