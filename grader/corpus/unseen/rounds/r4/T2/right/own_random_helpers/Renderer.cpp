// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

// a random number in -r .. r
static double plusMinus(double r) {
    return randomBetween(0.0, 2.0 * r) - r;
}

// rejection: throw points into the cube until one is in the ball
static Vector3 ballPoint(double r) {
    double x, y, z;
    do {
        x = plusMinus(r);
        y = plusMinus(r);
        z = plusMinus(r);
    } while (x * x + y * y + z * z > r * r);
    return Vector3(x, y, z);
}

static bool isFree(const Scene& scene, Vector3 from, Vector3 to) {
    Vector3 way = to - from;
    auto hit = scene.findClosestIntersection(Ray(from, way.normalised()));
    if (!hit) return true;
    return hit->distance > way.magnitude();
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
        int lit = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            Vector3 onLight = light.position() + ballPoint(settings().lightSize);
            if (isFree(scene, P + N * kShadowBias, onLight)) {
                lit = lit + 1;
            }
        }
        colour += (diffuse + specular) * lit / settings().shadowRayCount;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        Ray r = camera.castRay(x, y);
        Vector3 focus = r.origin + r.direction * (settings().dofFocalPlane / r.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; i++) {
            Vector3 lens(plusMinus(settings().dofAmount), plusMinus(settings().dofAmount), 0);
            sum += trace(scene, Ray(lens, (focus - lens).normalised()), settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
