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
            if (!(hit.has_value() && hit->distance < far)) clear++;
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
    const RenderSettings& s = settings();
    Image image(s);
    const Camera camera(s);
    std::vector<ColourRGB> sums(static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()));
    for (int pass = 0; pass < s.dofRayCount; ++pass) {
        std::size_t at = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const Vector3 direction = camera.castRay(x, y).direction;
                const Vector3 meeting = direction * (s.dofFocalPlane / direction.z);
                Vector3 start;
                start.x = randomBetween(-s.dofAmount / 2, s.dofAmount / 2);
                start.y = randomBetween(-s.dofAmount / 2, s.dofAmount / 2);
                sums[at++] += trace(scene, Ray{start, (meeting - start).normalised()}, s.bounces);
            }
    }
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            image.set(x, y, sums[static_cast<std::size_t>(y * image.width() + x)] * (1.0 / s.dofRayCount));
    return image;
}

}  // namespace raytracer
