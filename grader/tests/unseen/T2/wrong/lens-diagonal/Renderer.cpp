// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
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
        double lightFraction = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            const Vector3 o = P + N * kShadowBias;
            const Vector3 way =
                light.position() + settings().lightSize * Vector3::randomInsideUnitSphere() - o;
            const auto occluder = scene.findClosestIntersection(Ray{o, way});  // 1 is the light
            if (!occluder || occluder->distance > 1) lightFraction += 1.0 / settings().shadowRayCount;
        }
        colour += diffuse * lightFraction;
        colour += specular * lightFraction;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray ray = camera.castRay(x, y);
        const double t = settings().dofFocalPlane / ray.direction.z;
        const Vector3 focus = ray.origin + ray.direction * t;

        ColourRGB average;
        for (int i = 0; i < settings().dofRayCount; i++) {
            double offset = settings().dofAmount * randomBetween(-1.0, 1.0);
            Vector3 origin = ray.origin + Vector3(offset, offset, 0.0);
            Vector3 direction = (focus - origin).normalised();
            average += trace(scene, Ray(origin, direction), settings().bounces) /
                       settings().dofRayCount;
        }
        image.set(x, y, average);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
