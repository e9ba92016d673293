// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace raytracer {

namespace {
double gauss() {   // Box-Muller
    double a = randomBetween(0, 1);
    while (a <= 0) a = randomBetween(0, 1);
    return std::sqrt(-2 * std::log(a)) * std::cos(2 * std::numbers::pi * randomBetween(0, 1));
}
Vector3 ball() {
    Vector3 g{gauss(), gauss(), gauss()};
    return g.normalised() * std::cbrt(randomBetween(0, 1));
}
std::vector<double> strata(int n) {
    std::vector<double> v(n);
    for (int i = 0; i < n; i++) v[i] = -1 + 2 * (i + randomBetween(0, 1)) / n;
    for (int i = n - 1; i > 0; i--) std::swap(v[i], v[(int)randomBetween(0, i + 1)]);
    return v;
}
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
        int reached = 0;
        const Vector3 start = P + N * kShadowBias;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            Vector3 target = light.position() + ball() * settings().lightSize;
            Vector3 d = target - start;
            auto hit = scene.findClosestIntersection(Ray{start, d.normalised()});
            if (!hit || hit->distance > d.magnitude()) reached++;
        }
        colour += (diffuse + specular) * ((double)reached / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const int n = settings().dofRayCount;
        const auto lx = strata(n), ly = strata(n);
        const Ray r = camera.castRay(x, y);
        const Vector3 F = r.evaluateAt(settings().dofFocalPlane / r.direction.z);
        ColourRGB sum;
        for (int i = 0; i < n; i++) {
            const Vector3 E{lx[i] * settings().dofAmount, ly[i] * settings().dofAmount, 0.0};
            sum += trace(scene, {E, (F - E).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / n);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
