// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

class Bulb {
public:
    Bulb(const PointLight& l, double radius) : c(l.position()), r(radius) {}
    [[nodiscard]] double visibleFrom(const Vector3& p, const Scene& s, int rays) const {
        double part = 0;
        for (int i = 0; i < rays; ++i)
            if (open(p, c + Vector3::randomInsideUnitSphere() * r, s)) part += 1.0 / rays;
        return part;
    }

private:
    static bool open(const Vector3& a, const Vector3& b, const Scene& s) {
        const Vector3 d = b - a;
        const auto hit = s.findClosestIntersection({a, d});
        return !hit || hit->distance > 1.0;
    }
    Vector3 c;
    double r;
};

class Lens {
public:
    Lens(double halfSide, double plane) : a(halfSide), z(plane) {}
    Ray operator()(const Ray& pinhole) const {
        const Vector3 f = pinhole.direction * (z / pinhole.direction.z);
        const Vector3 e{a * randomBetween(-1, 1), a * randomBetween(-1, 1), 0};
        return {e, f - e};
    }

private:
    double a, z;
};

}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    ColourRGB out = scene.ambientLighting() * object.colour();
    const Vector3 V = (O - P).normalised();
    for (const auto& light : scene.pointLights()) {
        const Vector3 L = (light.position() - P).normalised();
        const ColourRGB E = light.illuminationAt((light.position() - P).magnitude());
        const double kd = object.phongKD() * std::max(0.0, N.dot(L));
        const double ks = object.phongKS() * std::pow(std::max(0.0, L.reflectIn(N).dot(V)), object.phongAlpha());
        // TASK T2.1 begin
        const double vis = Bulb(light, settings().lightSize).visibleFrom(P + N * kShadowBias, scene, settings().shadowRayCount);
        out += (object.colour() * kd + light.colour() * ks) * E * vis;
        // TASK T2.1 end
    }
    return out;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    const Lens lens{settings().dofAmount, settings().dofFocalPlane};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray pin = camera.castRay(x, y);
        ColourRGB c;
        for (int i = settings().dofRayCount; i; --i) c += trace(scene, lens(pin), settings().bounces);
        image.set(x, y, c / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
