// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

// reuse what is already there :)
static Vector3 focalPoint(const Ray& ray, double z) {
    static const Vector3 kTowardsUs{0, 0, -1};
    return ray.evaluateAt(Plane::distanceAlong(ray, Vector3{0, 0, z}, kTowardsUs));
}

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
        int i = settings().shadowRayCount, blocked = 0;
        while (i--) {
            Ray sr{P + N * kShadowBias, {}};
            sr.direction = light.position() - sr.origin + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const double far = sr.direction.magnitude();
            sr.direction /= far;
            if (auto h = scene.findClosestIntersection(sr))
                if (h->distance <= far) ++blocked;
        }
        const double light_fraction = double(settings().shadowRayCount - blocked) / settings().shadowRayCount;
        colour += light_fraction * diffuse + light_fraction * specular;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Vector3 focus = focalPoint(camera.castRay(x, y), settings().dofFocalPlane);
        const double a = settings().dofAmount;
        ColourRGB pixel{0.0};
        for (int n = 0; n < settings().dofRayCount; n++) {
            Vector3 eye;
            eye.y = randomBetween(-a, a);
            eye.x = randomBetween(-a, a);
            pixel += trace(scene, {eye, (focus - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, pixel /= settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
