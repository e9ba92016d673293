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
        double lit = 0;
        for (int k = settings().shadowRayCount; k > 0; --k) {
            const Vector3 from = P + kShadowBias * N;
            const Vector3 way = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere() - from;
            const auto h = scene.findClosestIntersection({from, way});
            lit += (h.has_value() && h->distance < 1.0) ? 0 : 1;   // distance counted in lengths of way
        }
        lit /= settings().shadowRayCount;
        colour += diffuse * lit;
        colour += specular * lit;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const int W = settings().width, H = settings().height;
        const double half = std::tan(std::numbers::pi / 8) * settings().dofFocalPlane;
        const double px = (2.0 * (x + 0.5) / W - 1) * half;
        const double py = (1 - 2.0 * (y + 0.5) / H) * half * H / W;
        const Vector3 F{px, py, settings().dofFocalPlane};
        (void)camera;
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; i++) {
            const Vector3 o{randomBetween(-1, 1) * settings().dofAmount, randomBetween(-1, 1) * settings().dofAmount, 0};
            sum += trace(scene, {o, (F - o).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
