// Tick 1*, option 2
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>

namespace raytracer {

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 toViewer = (O - P).normalised();
    ColourRGB ambient = object.colour() * scene.ambientLighting();
    ColourRGB lights;
    double totalShare = 0.0;

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
        int visible = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 origin = P + N * kShadowBias;
            const Vector3 end =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const auto hit = scene.findClosestIntersection({origin, (end - origin).normalised()});
            if (!hit || hit->distance > (end - origin).magnitude()) ++visible;
        }
        const double share = static_cast<double>(visible) / settings().shadowRayCount;
        lights += (diffuse + specular) * share;
        totalShare += share / scene.pointLights().size();
        // TASK T2.1 end
    }
    if (scene.pointLights().empty()) totalShare = 1.0;
    return ambient * totalShare + lights;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray ray = camera.castRay(x, y);
        const Vector3 focal = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 origin{randomBetween(-1, 1) * settings().dofAmount,
                                 randomBetween(-1, 1) * settings().dofAmount, 0};
            sum += trace(scene, Ray{origin, (focal - origin).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
