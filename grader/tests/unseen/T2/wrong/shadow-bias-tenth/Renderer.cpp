// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

// big enough to be sure that there is no shadow acne
static constexpr double EPSILON = 0.1;

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
        int unshadowed = 0;
        for (int ray = 0; ray < settings().shadowRayCount; ++ray) {
            const Vector3 from = P + N * EPSILON;
            const Vector3 to =
                light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const auto hit = scene.findClosestIntersection({from, (to - from).normalised()});
            unshadowed += (!hit || hit->distance > (to - from).magnitude()) ? 1 : 0;
        }
        colour += (diffuse + specular) * (unshadowed / (double)settings().shadowRayCount);
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
