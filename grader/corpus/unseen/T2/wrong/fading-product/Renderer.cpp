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
        double strength = 1.0;
        const double loss = 1.0 / settings().shadowRayCount;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 aim = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Ray shadowRay{P + N * kShadowBias, (aim - P).normalised()};
            const auto occluder = scene.findClosestIntersection(shadowRay);
            if (occluder && occluder->distance < distance) strength *= 1.0 - loss;  // this ray is lost
        }
        colour += (diffuse + specular) * strength;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const double half = settings().dofAmount / 2;
        const Ray ray = camera.castRay(x, y);
        const Vector3 fp = ray.direction * (settings().dofFocalPlane / ray.direction.z);
        ColourRGB c{0, 0, 0};
        int left = settings().dofRayCount;
        while (left-- > 0) {
            Vector3 lens{randomBetween(-half, half), 0, 0};
            lens.y = randomBetween(-half, half);
            c += trace(scene, Ray{lens, (fp - lens).normalised()}, settings().bounces);
        }
        c /= settings().dofRayCount;
        image.set(x, y, c);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
