// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {
typedef double Lanes __attribute__((vector_size(32)));
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
        double share = 0.0;
        const Vector3 start = P + N * kShadowBias;
        for (int n = 1; n <= settings().shadowRayCount; ++n) {
            const Vector3 path = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
            const double squared = path.dot(path);
            const auto hit = scene.findClosestIntersection(Ray{start, path / std::sqrt(squared)});
            const double sees = hit && hit->distance * hit->distance < squared ? 0.0 : 1.0;
            share += (sees - share) / n;
        }
        const Lanes both = Lanes{diffuse.r, diffuse.g, diffuse.b, 0} + Lanes{specular.r, specular.g, specular.b, 0};
        const Lanes seen = both * share;
        colour += ColourRGB{seen[0], seen[1], seen[2]};
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray pinhole = camera.castRay(x, y);
        const Vector3 focus = pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
        Lanes mean = {0, 0, 0, 0};
        for (int n = 1; n <= settings().dofRayCount; ++n) {
            const Vector3 lens{randomBetween(-1, 1) * settings().dofAmount, randomBetween(-1, 1) * settings().dofAmount, 0};
            const ColourRGB c = trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
            mean += (Lanes{c.r, c.g, c.b, 0} - mean) / static_cast<double>(n);
        }
        image.set(x, y, {mean[0], mean[1], mean[2]});
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
