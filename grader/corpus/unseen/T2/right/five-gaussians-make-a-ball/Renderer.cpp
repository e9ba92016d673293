// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace raytracer {

namespace {

/// Even bits to one coordinate, odd bits to the other.
std::pair<double, double> onMortonCurve(double along) {
    double s = 0.0, t = 0.0, size = 0.5;
    for (int bit = 0; bit < 26; ++bit, size *= 0.5) {
        along *= 2.0;
        if (along >= 1.0) { s += size; along -= 1.0; }
        along *= 2.0;
        if (along >= 1.0) { t += size; along -= 1.0; }
    }
    return {s, t};
}

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
        const Vector3 o = P + N * kShadowBias;
        int n = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            // Three of five coordinates of a uniform point of the 4-sphere are uniform in the ball
            // (Archimedes' theorem, two dimensions up).
            double g[6];
            for (int k = 0; k < 6; k += 2) {
                const double radius = std::sqrt(-2.0 * std::log(1.0 - randomBetween(0.0, 1.0)));
                const double angle = 2.0 * std::numbers::pi * randomBetween(0.0, 1.0);
                g[k] = radius * std::cos(angle);
                g[k + 1] = radius * std::sin(angle);
            }
            const double length = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2] + g[3] * g[3] + g[4] * g[4]);
            const Vector3 aim = light.position() + Vector3{g[0], g[1], g[2]} * (settings().lightSize / length);
            const auto hit = scene.findClosestIntersection({o, (aim - o).normalised()});
            if (!hit || hit->distance > (aim - o).magnitude()) ++n;
        }
        colour += (diffuse + specular) * (double(n) / double(settings().shadowRayCount));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray principal = camera.castRay(x, y);
        const Vector3 focus = principal.evaluateAt(settings().dofFocalPlane / principal.direction.z);
        // Points evenly along a Z-curve, with a random start: each is uniform on the square.
        const double begin = randomBetween(0.0, 1.0);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            double along = begin + (i + randomBetween(0.0, 1.0)) / settings().dofRayCount;
            along -= std::floor(along);
            const auto [s, t] = onMortonCurve(along);
            const Vector3 lens{(2.0 * s - 1.0) * settings().dofAmount, (2.0 * t - 1.0) * settings().dofAmount, 0.0};
            sum += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
