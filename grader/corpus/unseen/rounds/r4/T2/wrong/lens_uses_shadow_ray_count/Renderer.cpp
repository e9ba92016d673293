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
        double visible = 0;
        int n = settings().shadowRayCount;
        for (int k = 0; k != n; ++k) {
            const Vector3 jitter = Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 path = light.position() + jitter - (P + kShadowBias * N);
            const std::optional<RaycastHit> h =
                scene.findClosestIntersection(Ray(P + kShadowBias * N, path.normalised()));
            if (!h) {
                visible += 1;
            } else if (h->distance >= path.magnitude()) {
                visible += 1;
            }
        }
        visible = visible / n;
        colour += visible * (diffuse + specular);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray ray = camera.castRay(x, y);
        const Vector3 f = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        ColourRGB mean;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            const Vector3 o{settings().dofAmount * randomBetween(-1, 1),
                            settings().dofAmount * randomBetween(-1, 1), 0};
            mean += trace(scene, Ray{o, (f - o).normalised()}, settings().bounces) /
                    settings().shadowRayCount;
        }
        image.set(x, y, mean);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
