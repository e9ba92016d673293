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
        int lit = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            Vector3 target = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            Vector3 start = P + N * kShadowBias;
            double length = (target - start).magnitude();
            Ray ray(start, (target - start).normalised());
            bool blocked = false;
            for (int k = 1; k < (int)scene.objects().size(); k++) {
                auto hit = scene.objects()[k]->intersectionWith(ray);
                if (hit && hit->distance < length) {
                    blocked = true;
                }
            }
            if (blocked == false) lit++;
        }
        colour += (diffuse + specular) * ((double)lit / settings().shadowRayCount);
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
