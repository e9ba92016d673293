#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>

namespace raytracer {

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 eye = (O - P).normalised();
    ColourRGB out = object.colour() * scene.ambientLighting();
    for (const PointLight& lamp : scene.pointLights()) {
        const Vector3 way = lamp.position() - P;
        const Vector3 L = way.normalised();
        const ColourRGB power = lamp.illuminationAt(way.magnitude());
        ColourRGB direct = object.colour() * power * (object.phongKD() * std::max(0.0, N.dot(L)));
        direct += lamp.colour() * power *
                  (object.phongKS() *
                   std::pow(std::max(0.0, L.reflectIn(N).dot(eye)), object.phongAlpha()));
        int open = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 from = P + N * kShadowBias;
            const Vector3 aim =
                lamp.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Ray ray{from, (aim - from).normalised()};
            const auto hit = scene.findClosestIntersection(ray);
            if (!hit || hit->distance > (aim - from).magnitude()) ++open;
        }
        out += direct * (static_cast<double>(open) / settings().shadowRayCount);
    }
    return out;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    const double A = settings().dofAmount;
    forEachPixel(image, [&](int x, int y) {
        const Ray through = camera.castRay(x, y);
        const Vector3 sharp = through.direction * (settings().dofFocalPlane / through.direction.z);
        const bool outer = std::abs(x + 0.5 - image.width() / 2.0) > image.width() / 3.0;
        const int rays = outer ? settings().dofRayCount / 5 : settings().dofRayCount;
        ColourRGB sum;
        for (int i = 0; i < rays; ++i) {
            const Vector3 lens{randomBetween(-A, A), randomBetween(-A, A), 0.0};
            sum += trace(scene, Ray{lens, (sharp - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / rays);
    });
    return image;
}

}  // namespace raytracer
