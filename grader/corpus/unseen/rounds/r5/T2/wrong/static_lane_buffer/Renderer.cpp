// Data-oriented: aims and results in aligned arrays that are allocated once.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace raytracer {

namespace {
constexpr int kMaxLanes = 4096;
struct alignas(64) Lanes {
    std::array<double, kMaxLanes> x, y, z, open;
};
Lanes lanes;  // 128 KB do not belong on the stack
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
        const int n = std::min(settings().shadowRayCount, kMaxLanes);
        for (int i = 0; i < n; ++i) {
            const Vector3 q = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            lanes.x[i] = q.x;
            lanes.y[i] = q.y;
            lanes.z[i] = q.z;
            lanes.open[i] = 0.0;
        }
        const Vector3 start = P + N * kShadowBias;
        for (int i = 0; i < n; ++i) {
            const Vector3 way = Vector3{lanes.x[i], lanes.y[i], lanes.z[i]} - start;
            const auto hit = scene.findClosestIntersection({start, way.normalised()});
            if (!hit || hit->distance > way.magnitude()) lanes.open[i] = 1.0;
        }
        double share = 0.0;
        for (int i = 0; i < n; ++i) share += lanes.open[i];
        colour += (diffuse + specular) * (share / n);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 F = d * (settings().dofFocalPlane / d.z);
        const int n = settings().dofRayCount;
        ColourRGB mean;
        for (int i = 0; i < n; ++i) {
            Vector3 lens;
            lens.x = settings().dofAmount * randomBetween(-1.0, 1.0);
            lens.y = settings().dofAmount * randomBetween(-1.0, 1.0);
            mean += trace(scene, {lens, (F - lens).normalised()}, settings().bounces) * (1.0 / n);
        }
        image.set(x, y, mean);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
