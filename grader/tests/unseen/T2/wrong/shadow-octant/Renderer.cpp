// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

// random point in the sphere of radius r
static Vector3 randomInSphere(double r) {
    while (true) {
        double x = randomBetween(0, 1);
        double y = randomBetween(0, 1);
        double z = randomBetween(0, 1);
        if (x * x + y * y + z * z <= 1) {
            return Vector3(x * r, y * r, z * r);
        }
    }
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
        int inLight = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            Vector3 start = P + N * kShadowBias;
            Vector3 target = light.position() + randomInSphere(settings().lightSize);
            Vector3 path = target - start;
            auto hit = scene.findClosestIntersection(Ray(start, path.normalised()));
            bool blocked = hit.has_value() && hit->distance < path.magnitude();
            if (!blocked) inLight++;
        }
        colour += (diffuse + specular) * ((double)inLight / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

static Ray lensRay(const Vector3& focus, double halfSide) {
    const Vector3 eye{randomBetween(-halfSide, halfSide), randomBetween(-halfSide, halfSide), 0.0};
    return {eye, (focus - eye).normalised()};
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 focus = d * (settings().dofFocalPlane / d.z);
        ColourRGB sum;
        for (int n = settings().dofRayCount; n-- > 0;)
            sum += trace(scene, lensRay(focus, settings().dofAmount), settings().bounces);
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
