// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
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
        double mean = 0.0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            const Vector3 S = P + N * kShadowBias;
            const Vector3 T = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const auto X = scene.findClosestIntersection(Ray{S, (T - S).normalised()});
            double now = 1.0;
            if (X && (X->location - S).magnitude() < (T - S).magnitude()) now = 0.0;
            mean = mean + (now - mean) / (i + 1);
        }
        colour += diffuse * mean + specular * mean;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray r = camera.castRay(x, y);
        const Vector3 focus = r.evaluateAt(settings().dofFocalPlane / r.direction.z);
        ColourRGB mean;
        for (int i = 0; i < settings().dofRayCount; i++) {
            const Vector3 e{settings().dofAmount * randomBetween(-1.0, 1.0),
                            settings().dofAmount * randomBetween(-1.0, 1.0), 0.0};
            const ColourRGB c = trace(scene, Ray{e, (focus - e).normalised()}, settings().bounces);
            mean.r += (c.r - mean.r) / (i + 1);
            mean.g += (c.g - mean.g) / (i + 1);
            mean.b += (c.b - mean.b) / (i + 1);
        }
        image.set(x, y, mean);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
