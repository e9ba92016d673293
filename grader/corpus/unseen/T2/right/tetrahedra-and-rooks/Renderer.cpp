// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <array>
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
        int open = 0;
        std::array<Vector3, 4> corners;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            if (i % 4 == 0) {
                const Vector3 a = Vector3::randomInsideUnitSphere().normalised();
                Vector3 b = Vector3::randomInsideUnitSphere();
                b = (b - a * a.dot(b)).normalised();
                const Vector3 c = a.cross(b);
                const double k = 1 / std::sqrt(3.0);
                corners = {k * (a + b + c), k * (a - b - c), k * (b - a - c), k * (c - a - b)};
            }
            const double r = settings().lightSize * std::cbrt(randomBetween(0, 1));
            const Vector3 way = light.position() + corners[i % 4] * r - P;
            const auto hit = scene.findClosestIntersection({P + N * kShadowBias, way.normalised()});
            if (!hit || hit->distance > way.magnitude()) ++open;
        }
        const double s = open * 1.0 / settings().shadowRayCount;
        colour += s * (diffuse + specular);
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
        std::vector<int> rank(n);
        for (int i = 0; i < n; ++i) {
            const int j = std::min(i, int(randomBetween(0, i + 1)));
            rank[i] = rank[j];
            rank[j] = i;
        }
        const Ray pin = camera.castRay(x, y);
        const Vector3 F = pin.evaluateAt(settings().dofFocalPlane / pin.direction.z);
        const auto coordinate = [&](int stratum) {
            return settings().dofAmount * (2 * (stratum + randomBetween(0, 1)) / n - 1);
        };
        ColourRGB sum;
        for (int file = 0; file < n; ++file) {
            const Vector3 o{coordinate(file), coordinate(rank[file]), 0};
            sum += trace(scene, {o, (F - o).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / n);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
