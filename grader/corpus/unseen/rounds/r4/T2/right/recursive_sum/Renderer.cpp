// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

// how many of n rays arrive (returned as double because of the division)
static double countFree(const Scene& scene, const Vector3& start, const Vector3& centre, double size,
                        int n) {
    if (n == 0) return 0.0;
    Vector3 goal = centre + size * Vector3::randomInsideUnitSphere();
    auto hit = scene.findClosestIntersection(Ray(start, (goal - start).normalised()));
    double one = 1.0;
    if (hit && hit->distance <= (goal - start).magnitude()) one = 0.0;
    return one + countFree(scene, start, centre, size, n - 1);
}

// the sum of n lens rays
static ColourRGB addRays(const Renderer& renderer, const Scene& scene, const Vector3& focus, int n) {
    if (n == 0) return ColourRGB(0.0);
    double A = renderer.settings().dofAmount;
    double lx = A * randomBetween(-1, 1);
    double ly = A * randomBetween(-1, 1);
    Vector3 lens(lx, ly, 0);
    ColourRGB mine =
        renderer.trace(scene, Ray(lens, (focus - lens).normalised()), renderer.settings().bounces);
    return mine + addRays(renderer, scene, focus, n - 1);
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
        colour += (diffuse + specular) *
                  (countFree(scene, P + N * kShadowBias, light.position(), settings().lightSize,
                             settings().shadowRayCount) /
                   settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        Ray ray = camera.castRay(x, y);
        Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        image.set(x, y, addRays(*this, scene, focus, settings().dofRayCount) / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
