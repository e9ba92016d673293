#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>

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
        int hits = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            Vector3 target = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            Vector3 start = P + N * kShadowBias;
            double d = (target - start).magnitude();
            Ray r{start, (target - start).normalised()};
            auto hit = scene.findClosestIntersection(r);
            if (hit.has_value() && hit->distance < d) {
                hits++;
            }
        }
        double lit = 1.0 - (double)hits / settings().shadowRayCount;
        colour += diffuse * lit + specular * lit;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    // image goes from 0 to width - 1 and from 0 to height - 1
    for (int x = 0; x < image.width() - 1; x++) {
        for (int y = 0; y < image.height() - 1; y++) {
            Ray ray = camera.castRay(x, y);
            Vector3 f = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
            ColourRGB sum(0, 0, 0);
            for (int k = 0; k < settings().dofRayCount; k++) {
                Vector3 e(randomBetween(-settings().dofAmount, settings().dofAmount),
                          randomBetween(-settings().dofAmount, settings().dofAmount), 0);
                Ray lensRay(e, (f - e).normalised());
                sum += trace(scene, lensRay, settings().bounces);
            }
            sum /= settings().dofRayCount;
            image.set(x, y, sum);
        }
    }
    return image;
}

}  // namespace raytracer
