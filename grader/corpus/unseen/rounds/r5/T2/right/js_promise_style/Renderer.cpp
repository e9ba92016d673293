// renderer.mjs: Array.from({length: n}).map(...).reduce(...)
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <any>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace raytracer {

namespace js {

template <class T>
struct Array {
    std::vector<T> items;
    template <class F>
    static Array from(int length, F f) {
        Array a;
        for (int i = 0; i < length; i++) a.items.push_back(f(i));
        return a;
    }
    template <class F>
    Array filter(F f) const {
        Array a;
        for (const T& t : items)
            if (f(t)) a.items.push_back(t);
        return a;
    }
    template <class F, class A>
    A reduce(F f, A acc) const {
        for (const T& t : items) acc = f(acc, t);
        return acc;
    }
    int length() const { return int(items.size()); }
};
// Math.random()
inline double random() { return randomBetween(0, 1); }

}  // namespace js

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
        const auto origin = P + N * 1e-4;
        const auto rays = js::Array<Vector3>::from(settings().shadowRayCount, [&](int) {
            return light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - origin;
        });
        const auto arrived = rays.filter([&](const Vector3& way) {
            const auto hit = scene.findClosestIntersection(Ray(origin, way.normalised()));
            return !hit || hit->distance > way.magnitude();
        });
        // 1.0 *: numbers are doubles over there
        const auto share = 1.0 * arrived.length() / rays.length();
        colour += (diffuse + specular) * share;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const auto [fwd, focalZ, size] = std::make_tuple(camera.castRay(x, y).direction, settings().dofFocalPlane, settings().dofAmount);
        const auto focal = fwd * (focalZ / fwd.z);
        const auto jitter = [size = size] { return (js::random() - 0.5) * 2 * size; };
        const auto samples = js::Array<ColourRGB>::from(settings().dofRayCount, [&](int) {
            const auto dx = jitter(), dy = jitter();
            const Vector3 from(dx, dy, 0);
            return trace(scene, Ray(from, (focal - from).normalised()), settings().bounces);
        });
        image.set(x, y, samples.reduce([](ColourRGB a, ColourRGB b) { return a + b; }, ColourRGB()) / samples.length());
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
