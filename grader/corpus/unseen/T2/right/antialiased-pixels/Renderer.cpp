// Extra: the rays of a pixel are also spread over the pixel's own square, so edges in focus are
// antialiased for free. Each ray has a focal point of its own inside the square that the pixel
// covers in the focal plane.
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
        const Vector3 surfacePoint = P + N * kShadowBias;
        int unoccluded = 0;
        for (int s = 0; s < settings().shadowRayCount; ++s) {
            const Vector3 lightPoint =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 direction = (lightPoint - surfacePoint).normalised();
            const auto hit = scene.findClosestIntersection({surfacePoint, direction});
            // compare squares: saves a root
            const Vector3 toHit = hit ? hit->location - surfacePoint : Vector3{};
            const Vector3 toLightPoint = lightPoint - surfacePoint;
            if (!hit || toHit.dot(toHit) > toLightPoint.dot(toLightPoint)) ++unoccluded;
        }
        const double share = unoccluded / double(settings().shadowRayCount);
        colour += (diffuse + specular) * share;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray middle = camera.castRay(x, y);
        const double z = settings().dofFocalPlane;
        const Vector3 focalMiddle = middle.evaluateAt(z / middle.direction.z);
        // side of a pixel on the plane z = 1: the horizontal field of view is 45 degrees
        const double pixel = 2.0 * std::tan(std::numbers::pi / 8.0) / settings().width;

        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 focal =
                focalMiddle +
                Vector3{randomBetween(-0.5, 0.5), randomBetween(-0.5, 0.5), 0.0} * (pixel * z);
            const Vector3 eye{randomBetween(-1.0, 1.0) * settings().dofAmount,
                              randomBetween(-1.0, 1.0) * settings().dofAmount, 0.0};
            sum += trace(scene, Ray{eye, (focal - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
