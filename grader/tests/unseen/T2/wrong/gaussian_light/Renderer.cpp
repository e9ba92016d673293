// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

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
        thread_local std::mt19937 engine{std::random_device{}()};
        std::normal_distribution<double> around{0.0, settings().lightSize};
        const Vector3 start = P + N * kShadowBias;
        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 target = light.position() + Vector3{around(engine), around(engine), around(engine)};
            const Vector3 way = target - start;
            const auto hit = scene.findClosestIntersection({start, way.normalised()});
            if (!hit || hit->distance > way.magnitude()) ++arrived;
        }
        colour += (diffuse + specular) * (static_cast<double>(arrived) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray central = camera.castRay(x, y);
        const double t = (settings().dofFocalPlane - central.origin.z) / central.direction.z;
        const Vector3 F = central.origin + t * central.direction;
        const auto lensRay = [&] {
            Vector3 o = central.origin;
            o.x += settings().dofAmount * randomBetween(-1, 1);
            o.y += settings().dofAmount * randomBetween(-1, 1);
            return Ray{o, (F - o).normalised()};
        };
        ColourRGB total;
        int rays = settings().dofRayCount;
        while (rays-- > 0) total += trace(scene, lensRay(), settings().bounces);
        image.set(x, y, total * (1.0 / settings().dofRayCount));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
