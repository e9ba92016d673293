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
            Ray ray(start, (target - start).normalised());
            // what does the ray hit?
            std::optional<RaycastHit> occluder;
            for (const auto& o : scene.objects()) {
                std::optional<RaycastHit> hit = o->intersectionWith(ray);
                if (hit) {
                    occluder = hit;
                }
            }
            if (!occluder || occluder->distance > (target - start).magnitude()) lit++;
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
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 F = d * (settings().dofFocalPlane / d.z);
        const double A = settings().dofAmount;
        const int n = settings().dofRayCount;
        double red = 0, green = 0, blue = 0;
        for (int k = 1; k <= n; ++k) {
            const Vector3 eye{randomBetween(-A, A), randomBetween(-A, A), 0.0};
            const ColourRGB c = trace(scene, Ray{eye, (F - eye).normalised()}, settings().bounces);
            red += c.r;
            green += c.g;
            blue += c.b;
        }
        image.set(x, y, ColourRGB{red / n, green / n, blue / n});
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
