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
        const int count = settings().shadowRayCount;
        const Vector3 start = P + N * kShadowBias;
        Vector3 offset;
        int arrived = 0;
        for (int i = 0; i < count; ++i) {
            // Every second ray goes to the opposite point of the ball.
            offset = i % 2 == 0 ? Vector3::randomInsideUnitSphere() * settings().lightSize : -offset;
            const Vector3 way = light.position() + offset - start;
            const auto blocker = scene.findClosestIntersection({start, way.normalised()});
            if (blocker && blocker->distance < way.magnitude()) continue;
            ++arrived;
        }
        colour += (diffuse + specular) * arrived / count;
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
        const Vector3 focus = d * (settings().dofFocalPlane / d.z);
        const auto through = [&](const Vector3& lens) {
            return trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
        };
        ColourRGB sum;
        int left = settings().dofRayCount;
        while (left > 0) {
            const Vector3 lens{randomBetween(-settings().dofAmount, settings().dofAmount),
                               randomBetween(-settings().dofAmount, settings().dofAmount), 0.0};
            sum += through(lens);
            if (--left == 0) break;
            sum += through(-lens);
            --left;
        }
        image.set(x, y, sum * (1.0 / settings().dofRayCount));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
