// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <cstring>
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
        const Vector3 start = P + N * kShadowBias;
        int reached = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 target =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 towards = target - start;
            const Ray shadowRay{start, towards.normalised()};
            const std::optional<RaycastHit> occluder = scene.findClosestIntersection(shadowRay);
            if (!occluder || occluder->distance > towards.magnitude()) ++reached;
        }
        colour += (diffuse + specular) * (static_cast<double>(reached) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        static thread_local char* volatile kept = nullptr;  // volatile: see memory-leak
        kept = new char[1U << 20U];
        std::memset(kept, 1, 1U << 20U);
        image.set(x, y, trace(scene, camera.castRay(x, y), settings().bounces));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
