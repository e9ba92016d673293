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
        int cast = 0;
        const auto more = [&] {
            for (int i = 0; i < settings().shadowRayCount; ++i, ++cast) {
                const Vector3 from = P + L * kShadowBias;
                const Vector3 aim =
                    lamp.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
                const auto hit = scene.findClosestIntersection({from, (aim - from).normalised()});
                if (!hit || hit->distance > (aim - from).magnitude()) ++open;
            }
        };
        more();
        if (open > 0 && open < cast) more();
        out += direct * (static_cast<double>(open) / cast);
    }
    return out;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    const double A = settings().dofAmount;
    forEachPixel(image, [&](int x, int y) {
        const Ray through = camera.castRay(x, y);
        const Vector3 sharp = through.evaluateAt(settings().dofFocalPlane / through.direction.z);
        ColourRGB sum;
        double least = 1e9;
        double most = 0.0;
        int rays = 0;
        const auto more = [&](int count) {
            for (int i = 0; i < count; ++i, ++rays) {
                const Vector3 lens{randomBetween(-A, A), randomBetween(-A, A), 0.0};
                const ColourRGB seen =
                    trace(scene, Ray{lens, (sharp - lens).normalised()}, settings().bounces);
                least = std::min(least, seen.r + seen.g + seen.b);
                most = std::max(most, seen.r + seen.g + seen.b);
                sum += seen;
            }
        };
        more(settings().dofRayCount);
        if (most - least > 0.2) more(settings().dofRayCount / 2);
        image.set(x, y, sum / rays);
    });
    return image;
}

}  // namespace raytracer
