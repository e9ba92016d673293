// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace raytracer {
namespace {

struct KahanSum {
    double sum = 0.0;
    double lost = 0.0;
    void add(double value) {
        const double y = value - lost;
        const double t = sum + y;
        lost = (t - sum) - y;
        sum = t;
    }
};

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
        const Vector3 goal = P + N * kShadowBias;
        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 source = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const std::optional<RaycastHit> stop = scene.findClosestIntersection(Ray{source, goal - source});
            if (!stop.has_value() || stop->distance >= 1.0) ++arrived;
        }
        const double share = static_cast<double>(arrived) / settings().shadowRayCount;
        colour += share * (diffuse + specular);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const auto [eye, gaze] = camera.castRay(x, y);
        const Vector3 focal = eye + gaze * (settings().dofFocalPlane / gaze.z);
        KahanSum red, green, blue;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            Vector3 from = eye;
            from.x += settings().dofAmount * randomBetween(-1, 1);
            from.y += settings().dofAmount * randomBetween(-1, 1);
            const ColourRGB c = trace(scene, Ray{from, (focal - from).normalised()}, settings().bounces);
            red.add(c.r);
            green.add(c.g);
            blue.add(c.b);
        }
        const double n = settings().dofRayCount;
        image.set(x, y, {red.sum / n, green.sum / n, blue.sum / n});
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
