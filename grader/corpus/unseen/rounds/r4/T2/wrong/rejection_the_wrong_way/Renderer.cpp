// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

// my own ball, by rejection
static Vector3 randomBall() {
    Vector3 v;
    do {
        v.x = randomBetween(-1, 1);
        v.y = randomBetween(-1, 1);
        v.z = randomBetween(-1, 1);
    } while (v.x * v.x + v.y * v.y + v.z * v.z < 1);
    return v;
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
        int free = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            Vector3 target = light.position() + randomBall() * settings().lightSize;
            Vector3 start = P + kShadowBias * N;
            Vector3 d = target - start;
            auto h = scene.findClosestIntersection(Ray(start, d.normalised()));
            if (!h || h->distance > d.magnitude()) ++free;
        }
        colour += (diffuse + specular) * free / settings().shadowRayCount;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        ColourRGB pixel;
        const Ray middle = camera.castRay(x, y);
        // similar triangles: the plane is dofFocalPlane away in z
        const double f = settings().dofFocalPlane;
        const Vector3 focal{middle.direction.x / middle.direction.z * f,
                            middle.direction.y / middle.direction.z * f, f};
        int i = 0;
        while (i < settings().dofRayCount) {
            Vector3 lens;
            lens.x = (2 * randomBetween(0, 1) - 1) * settings().dofAmount;
            lens.y = (2 * randomBetween(0, 1) - 1) * settings().dofAmount;
            Vector3 towards = focal - lens;
            towards = towards.normalised();
            pixel = pixel + trace(scene, Ray(lens, towards), settings().bounces);
            i++;
        }
        image.set(x, y, pixel / (double)settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
