// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
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
        int free = 0;
        for (int k = 0; k < settings().shadowRayCount; k++) {
            Vector3 spot = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            Vector3 way = spot - P;
            auto hit = scene.findClosestIntersection(Ray{P + N * kShadowBias, way.normalised()});
            if (!hit.has_value() || hit->distance >= way.dot(way)) free++;
        }
        double lit = double(free) / settings().shadowRayCount;
        colour += diffuse * lit + specular * lit;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const double a = settings().dofAmount;
        const int rays = settings().dofRayCount;
        const Ray middle = camera.castRay(x, y);
        // z of the focal point is the focal distance; x and y follow by similar triangles
        const double f = settings().dofFocalPlane;
        const Vector3 sharp{f * middle.direction.x / middle.direction.z,
                            f * middle.direction.y / middle.direction.z, f};
        ColourRGB mean;
        for (int ray = 0; ray < rays; ++ray) {
            const double dx = randomBetween(-a, a), dy = randomBetween(-a, a);
            const Vector3 lens = middle.origin + Vector3{dx, dy, 0.0};
            mean += trace(scene, {lens, (sharp - lens).normalised()}, settings().bounces) / rays;
        }
        image.set(x, y, mean);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
