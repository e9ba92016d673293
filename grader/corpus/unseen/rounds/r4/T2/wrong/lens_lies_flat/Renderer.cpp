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
        Ray ray = camera.castRay(x, y);
        Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; i++) {
            double r1 = randomBetween(-1, 1) * settings().dofAmount;
            double r2 = randomBetween(-1, 1) * settings().dofAmount;
            Vector3 origin(r1, 0, r2);
            sum += trace(scene, Ray(origin, (focus - origin).normalised()), settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
