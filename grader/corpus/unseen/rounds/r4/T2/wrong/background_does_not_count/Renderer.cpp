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
        int count = settings().shadowRayCount;
        int arrived = 0;
        while (count > 0) {
            Vector3 point = Vector3::randomInsideUnitSphere();
            point *= settings().lightSize;
            point += light.position();
            Vector3 from = P + N * kShadowBias;
            Vector3 dir = point - from;
            double length = dir.magnitude();
            dir /= length;
            if (auto o = scene.findClosestIntersection({from, dir}); !o || o->distance > length) arrived++;
            count--;
        }
        double share = arrived * 1.0 / settings().shadowRayCount;
        colour += diffuse * share;
        colour += specular * share;
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
        Vector3 focal = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        ColourRGB sum;
        int used = 0;
        for (int i = 0; i < settings().dofRayCount; i++) {
            Vector3 lens(settings().dofAmount * randomBetween(-1, 1),
                         settings().dofAmount * randomBetween(-1, 1), 0);
            Ray lensRay(lens, (focal - lens).normalised());
            // only rays that hit something have a colour
            if (!scene.findClosestIntersection(lensRay)) continue;
            sum += trace(scene, lensRay, settings().bounces);
            used++;
        }
        if (used == 0) {
            image.set(x, y, kBackgroundColour);
        } else {
            image.set(x, y, sum / used);
        }
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
