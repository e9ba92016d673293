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
        const Vector3 start = P + N * kShadowBias;
        int visible = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 target =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 path = target - start;
            const auto hit = scene.findClosestIntersection(Ray{start, path.normalised()});
            if (!hit || hit->distance > path.magnitude()) ++visible;
        }
        colour += (diffuse + specular) * (double(visible) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray pinhole = camera.castRay(x, y);
        // the ray crosses the image plane at z = 1 and goes on from there to the focal plane
        const Vector3 onImagePlane = pinhole.direction / pinhole.direction.z;
        const Vector3 focus = onImagePlane * (settings().dofFocalPlane - 1.0);

        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens{randomBetween(-settings().dofAmount, settings().dofAmount),
                               randomBetween(-settings().dofAmount, settings().dofAmount), 0.0};
            sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
