// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <array>

namespace raytracer {

static double wrap(double t) { return t - std::floor(t); }

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
        constexpr std::array<double, 3> step{0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
        std::array<double, 3> s{randomBetween(0, 1), randomBetween(0, 1), randomBetween(0, 1)};
        const Vector3 begin = P + N * kShadowBias;
        int clear = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            for (int k = 0; k < 3; ++k)
                s[k] = wrap(s[k] + step[k]);
            const double z = 2 * s[0] - 1, r = std::sqrt(1 - z * z), a = 2 * std::numbers::pi * s[1];
            const Vector3 offset = Vector3{r * std::cos(a), r * std::sin(a), z} * (settings().lightSize * std::cbrt(s[2]));
            const Vector3 path = light.position() + offset - begin;
            const double length = path.magnitude();
            const auto hit = scene.findClosestIntersection({begin, path * (1 / length)});
            clear += !(hit && hit->distance < length);
        }
        colour += (diffuse + specular) * (clear / double(settings().shadowRayCount));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray pin = camera.castRay(x, y);
        const Vector3 focus = pin.evaluateAt(settings().dofFocalPlane / pin.direction.z);
        double u = randomBetween(0, 1), v = randomBetween(0, 1);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            u = wrap(u + 0.7548776662466927);
            v = wrap(v + 0.5698402909980532);
            const Vector3 lens = Vector3{2 * u - 1, 2 * v - 1, 0} * settings().dofAmount;
            sum += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
