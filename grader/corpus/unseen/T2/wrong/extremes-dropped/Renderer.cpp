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
        // share of the ball that can be seen from here
        const auto n = settings().shadowRayCount;
        double visible = 0.0;
        const Vector3 from = P + kShadowBias * N;
        for (auto left = n; left > 0; --left) {
            const Vector3 arrow =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - from;
            const double length = arrow.magnitude();
            const auto blocker = scene.findClosestIntersection({from, arrow / length});
            visible += (blocker && blocker->distance < length) ? 0.0 : 1.0 / n;
        }
        colour += visible * (diffuse + specular);
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
        std::vector<ColourRGB> seen;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 o{randomBetween(-1, 1) * settings().dofAmount, randomBetween(-1, 1) * settings().dofAmount, 0};
            seen.push_back(trace(scene, {o, (focus - o).normalised()}, settings().bounces));
        }
        std::sort(seen.begin(), seen.end(), [](const ColourRGB& a, const ColourRGB& b) { return a.r + a.g + a.b < b.r + b.g + b.b; });
        const std::size_t drop = seen.size() / 5;
        ColourRGB sum;
        for (std::size_t i = drop; i < seen.size() - drop; ++i) sum += seen[i];
        image.set(x, y, sum / double(seen.size() - 2 * drop));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
