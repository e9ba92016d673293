// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace raytracer {

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    // TASK T2.1 begin
    // Durchgang 1: Sichtbarkeit
    const std::size_t lights = scene.pointLights().size();
    std::vector<int> hits(lights, 0);
    for (int ray = 0; ray < settings().shadowRayCount; ++ray)
        for (std::size_t l = 0; l < lights; ++l) {   // lights inside!
            const Vector3 s = P + N * kShadowBias;
            const Vector3 t = scene.pointLights()[l].position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const auto h = scene.findClosestIntersection(Ray{s, (t - s).normalised()});
            if (!h || h->distance > (t - s).magnitude()) ++hits[l];
        }
    // TASK T2.1 end
    // Durchgang 2: Phong
    const Vector3 V = (O - P).normalised();
    ColourRGB c = object.colour() * scene.ambientLighting();
    for (std::size_t l = 0; l < lights; ++l) {
        const PointLight& light = scene.pointLights()[l];
        const double share = 1.0 * hits[l] / settings().shadowRayCount;
        const Vector3 L = (light.position() - P).normalised();
        const ColourRGB I = light.illuminationAt((light.position() - P).magnitude()) * share;
        c += object.colour() * I * object.phongKD() * std::max(0.0, N.dot(L));
        c += light.colour() * I * object.phongKS() * std::pow(std::max(0.0, L.reflectIn(N).dot(V)), object.phongAlpha());
    }
    return c;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        std::vector<ColourRGB> colours(settings().dofRayCount);
        const Ray pr = camera.castRay(x, y);
        const double scale = settings().dofFocalPlane / pr.direction.z;
        for (ColourRGB& c : colours) {
            const double ex = randomBetween(-1.0, 1.0) * settings().dofAmount;
            const double ey = randomBetween(-1.0, 1.0) * settings().dofAmount;
            const Vector3 dir{scale * pr.direction.x - ex, scale * pr.direction.y - ey, settings().dofFocalPlane};
            c = trace(scene, Ray{Vector3{ex, ey, 0}, dir.normalised()}, settings().bounces);
        }
        double rgb[3] = {0, 0, 0};
        for (const ColourRGB& c : colours) rgb[0] += c.r, rgb[1] += c.g, rgb[2] += c.b;
        const double n = static_cast<double>(colours.size());
        image.set(x, y, ColourRGB(rgb[0] / n, rgb[1] / n, rgb[2] / n));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
