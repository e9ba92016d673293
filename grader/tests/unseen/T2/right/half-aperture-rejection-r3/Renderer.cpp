// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

static Vector3 rnd(double r) {
again:
    const double a = randomBetween(-r, r), b = randomBetween(-r, r), c = randomBetween(-r, r);
    if (a * a + b * b + c * c > r * r) goto again;
    return Vector3(a, b, c);
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
        double lit = 0;
        for (int k = settings().shadowRayCount; k > 0; --k) {
            const Vector3 from = P + kShadowBias * N;
            const Vector3 way = light.position() + rnd(settings().lightSize) - from;
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
        Ray centre_ray = camera.castRay(x, y);
        Vector3 focus = centre_ray.direction * settings().dofFocalPlane / centre_ray.direction.z;
        ColourRGB out;
        for (int s = 0; s < settings().dofRayCount; ++s) {
            Vector3 o((randomBetween(0, 1) - 0.5) * settings().dofAmount,
                      (randomBetween(0, 1) - 0.5) * settings().dofAmount, 0);
            out += trace(scene, Ray(o, (focus - o).normalised()), settings().bounces);
        }
        out *= 1.0 / settings().dofRayCount;
        image.set(x, y, out);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
