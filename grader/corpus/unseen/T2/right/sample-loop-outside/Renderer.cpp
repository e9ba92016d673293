#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace raytracer {

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const std::vector<PointLight>& lights = scene.pointLights();
    std::vector<int> reached(lights.size());
    for (int i = 0; i < settings().shadowRayCount; ++i)
        for (std::size_t l = lights.size(); l-- > 0;) {
            const Vector3 start = P + N * kShadowBias;
            const Vector3 way = lights[l].position() +
                                Vector3::randomInsideUnitSphere() * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection({start, way.normalised()});
            if (!hit || hit->distance > way.magnitude()) ++reached[l];
        }
    ColourRGB colour = object.colour() * scene.ambientLighting();
    for (std::size_t l = 0; l < lights.size(); ++l) {
        const Vector3 L = (lights[l].position() - P).normalised();
        const ColourRGB I = lights[l].illuminationAt((lights[l].position() - P).magnitude()) *
                            (static_cast<double>(reached[l]) / settings().shadowRayCount);
        colour += object.colour() * I * (object.phongKD() * std::max(0.0, N.dot(L)));
        colour +=
            lights[l].colour() * I *
            (object.phongKS() * std::pow(std::max(0.0, L.reflectIn(N).dot((O - P).normalised())),
                                         object.phongAlpha()));
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray pinhole = camera.castRay(x, y);
        const Vector3 focus = pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double a = settings().dofAmount;
            const Vector3 lens{randomBetween(-a, a), randomBetween(-a, a), 0};
            sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
