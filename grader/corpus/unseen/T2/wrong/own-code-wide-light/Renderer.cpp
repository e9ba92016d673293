#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>

namespace raytracer {

namespace {

std::optional<RaycastHit> nearestOf(const Scene& scene, const Ray& ray) {
    std::optional<RaycastHit> best;
    for (const auto& thing : scene.objects()) {
        auto hit = thing->intersectionWith(ray);
        if (hit && (!best || hit->distance < best->distance)) best = hit;
    }
    return best;
}

bool clearBetween(const Scene& scene, const Vector3& from, const Vector3& to) {
    const Vector3 way = to - from;
    const auto hit = nearestOf(scene, {from, way.normalised()});
    return !hit || hit->distance > way.magnitude();
}

}  // namespace

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
        for (int i = 0; i < settings().shadowRayCount; ++i)
            if (clearBetween(scene, P + N * kShadowBias,
                             lamp.position() + Vector3::randomInsideUnitSphere() * 0.5))
                ++open;
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
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens{randomBetween(-A, A), randomBetween(-A, A), 0.0};
            sum += trace(scene, Ray{lens, (sharp - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
