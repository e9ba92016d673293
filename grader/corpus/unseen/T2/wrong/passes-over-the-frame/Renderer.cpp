#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <cstddef>
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

        // TASK T2.1 begin
        const Vector3 start = P + N * kShadowBias;
        int lit = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            const Vector3 aim = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const Vector3 way = aim - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
            if (!hit || hit->distance >= way.magnitude()) lit++;
        }
        const double share = lit / static_cast<double>(settings().shadowRayCount);
        colour += share * diffuse + share * specular;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    // TASK T2.2 begin
    std::vector<ColourRGB> sums(static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()));
    for (int pass = 0; pass < settings().dofRayCount; ++pass)
        forEachPixel(image, [&](int x, int y) {
            const Ray ray = camera.castRay(x, y);
            const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
            const Vector3 lens{randomBetween(-settings().dofAmount, settings().dofAmount),
                               randomBetween(-settings().dofAmount, settings().dofAmount), 0.0};
            sums[static_cast<std::size_t>(y * image.width() + x)] += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
        });
    forEachPixel(image, [&](int x, int y) {
        image.set(x, y, sums[static_cast<std::size_t>(y * image.width() + x)] / settings().dofRayCount);
    });
    // TASK T2.2 end
    return image;
}

}  // namespace raytracer
