// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

static thread_local bool rendering = false;

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
        const int count = rendering ? 1 : settings().shadowRayCount;
        int arrived = 0;
        for (int i = 0; i < count; ++i) {
            const Vector3 start = P + N * kShadowBias;
            const Vector3 d = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
            const auto h = scene.findClosestIntersection(Ray{start, d.normalised()});
            if (!h || h->distance > d.magnitude()) ++arrived;
        }
        colour += (diffuse + specular) * (double(arrived) / count);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        rendering = true;
        const Ray r = camera.castRay(x, y);
        const Vector3 focus = r.direction * (settings().dofFocalPlane / r.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; i++) {
            double ax = settings().dofAmount * randomBetween(-1, 1);
            double ay = settings().dofAmount * randomBetween(-1, 1);
            Vector3 eye{ax, ay, 0};
            sum += trace(scene, Ray{eye, (focus - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        rendering = false;
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
