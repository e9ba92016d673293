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

        double count = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            const Vector3 start = P + N * kShadowBias;
            const Vector3 aim = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const auto hit = scene.findClosestIntersection(Ray{start, (aim - start).normalised()});
            if (hit) {
                if (hit->distance > (aim - start).magnitude()) {
                    count++;
                }
            } else {
                count++;
            }
        }
        colour += (diffuse + specular) * (count / settings().shadowRayCount);
        return colour;
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        Ray ray = camera.castRay(x, y);
        double t = settings().dofFocalPlane / ray.direction.z;
        Vector3 focus = ray.evaluateAt(t);
        ColourRGB total(0, 0, 0);
        for (int i = 0; i < settings().dofRayCount; i++) {
            double dx = settings().dofAmount * randomBetween(-1, 1);
            double dy = settings().dofAmount * randomBetween(-1, 1);
            Vector3 origin(dx, dy, 0);
            Ray newRay(origin, (focus - origin).normalised());
            total += trace(scene, newRay, settings().bounces);
        }
        total /= settings().dofRayCount;
        image.set(x, y, total);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
