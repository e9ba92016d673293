#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace raytracer {


ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    ColourRGB total = object.colour() * scene.ambientLighting();
    for (const auto& light : scene.pointLights()) {
        const Vector3 d = light.position() - P;
        const double far = d.magnitude();
        const Vector3 L = d / far;
        int clear = 0;
        for (int k = 0; k < settings().shadowRayCount; k++) {
            const Vector3 goal = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const Vector3 from = P + kShadowBias * N;
            const auto hit = scene.findClosestIntersection({from, (goal - from).normalised()});
            if (!hit) clear++;
        }
        const double share = clear / static_cast<double>(settings().shadowRayCount);
        const ColourRGB I = light.illuminationAt(far);
        const double cosine = std::max(N.dot(L), 0.0);
        const double shine = std::pow(std::max(L.reflectIn(N).dot((O - P).normalised()), 0.0), object.phongAlpha());
        total += object.colour() * I * (object.phongKD() * cosine * share);
        total += light.colour() * I * (object.phongKS() * shine * share);
    }
    return total;
}

Image Renderer::render(const Scene& scene) const {
    Image picture(settings());
    const Camera camera(settings());
    for (int y = 0; y < picture.height(); y++) {
        for (int x = 0; x < picture.width(); x++) {
            const Ray middle = camera.castRay(x, y);
            const Vector3 focus = middle.direction * (settings().dofFocalPlane / middle.direction.z);
            ColourRGB sum;
            for (int i = 0; i < settings().dofRayCount; i++) {
                const Vector3 lens(settings().dofAmount * randomBetween(-1, 1), settings().dofAmount * randomBetween(-1, 1), 0);
                sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
            }
            picture.set(x, y, sum * (1.0 / settings().dofRayCount));
        }
    }
    return picture;
}

}  // namespace raytracer
