// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

struct Visibility { int open; int all; };
static const Visibility& look(const Scene& s, const Vector3& p, const PointLight& l, const RenderSettings& o) {
    static Visibility v;      // like localtime() :)
    v.open = 0;
    for (v.all = 0; v.all < o.shadowRayCount; v.all++) {
        const Vector3 q = l.position() + Vector3::randomInsideUnitSphere() * o.lightSize - p;
        const auto h = s.findClosestIntersection({p, q});
        if (!h || h->distance > 1) v.open++;
    }
    return v;
}

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
        const Visibility& v = look(scene, P + N * kShadowBias, light, settings());
        colour += (diffuse + specular) * ((double)v.open / v.all);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const double A = settings().dofAmount;
        const auto pin = camera.castRay(x, y);
        const auto F = pin.evaluateAt(settings().dofFocalPlane / pin.direction.z);
        double r = 0, g = 0, b = 0;
        int n = 0;
        while (n < settings().dofRayCount) {
            const Vector3 lens(randomBetween(-A, A), randomBetween(-A, A), 0.0);
            const ColourRGB c = trace(scene, {lens, (F - lens).normalised()}, settings().bounces);
            r += c.r; g += c.g; b += c.b;
            ++n;
        }
        image.set(x, y, {r / n, g / n, b / n});
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
