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
        int hits = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            // jitter the direction to the light
            Vector3 jitter = Vector3::randomInsideUnitSphere() * settings().lightSize;
            Vector3 direction = (toLight + jitter).normalised();
            Ray shadowRay(P + N * kShadowBias, direction);
            auto occluder = scene.findClosestIntersection(shadowRay);
            if (occluder && occluder->distance < distance) hits++;
        }
        double lit = 1.0 - (double)hits / settings().shadowRayCount;
        colour += (diffuse + specular) * lit;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        Ray originalRay = camera.castRay(x, y);
        Vector3 focusPoint =
            originalRay.evaluateAt(settings().dofFocalPlane / originalRay.direction.z);
        double red = 0;
        double green = 0;
        double blue = 0;
        int n = settings().dofRayCount;
        for (int i = 0; i < n; i++) {
            // random point on the square aperture
            Vector3 lensPoint;
            lensPoint.x = randomBetween(-1, 1) * settings().dofAmount;
            lensPoint.y = randomBetween(-1, 1) * settings().dofAmount;
            lensPoint.z = 0;
            ColourRGB c = trace(scene, Ray(lensPoint, (focusPoint - lensPoint).normalised()),
                                settings().bounces);
            red += c.r;
            green += c.g;
            blue += c.b;
        }
        image.set(x, y, ColourRGB(red / n, green / n, blue / n));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
