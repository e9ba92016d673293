// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <coroutine>
#include <exception>
#include <utility>
namespace raytracer {

namespace {
template <class T>
struct Generator {
    struct promise_type {
        T value;
        Generator get_return_object() { return Generator{std::coroutine_handle<promise_type>::from_promise(*this)}; }
        std::suspend_always initial_suspend() { return {}; }
        std::suspend_always final_suspend() noexcept { return {}; }
        std::suspend_always yield_value(T v) { value = v; return {}; }
        void return_void() {}
        void unhandled_exception() { std::terminate(); }
    };
    std::coroutine_handle<promise_type> h;
    explicit Generator(std::coroutine_handle<promise_type> x) : h(x) {}
    Generator(Generator&& o) noexcept : h(std::exchange(o.h, {})) {}
    Generator(const Generator&) = delete;
    ~Generator() { if (h) h.destroy(); }
    bool next() { h.resume(); return !h.done(); }
    T get() const { return h.promise().value; }
};
Generator<Vector3> lensPoints(int n, double size) {
    for (int i = 0; i < n; ++i) {
        const double px = randomBetween(-size, size);
        const double py = randomBetween(-size, size);
        co_yield Vector3{px, py, 0.0};
    }
}
Generator<Vector3> lightPoints(int n, Vector3 centre, double size) {
    for (int i = 0; i < n; ++i) co_yield centre + size * Vector3::randomInsideUnitSphere();
}
}

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

        const Vector3 start = P + N * kShadowBias;
        double reached = 0;
        auto points = lightPoints(settings().shadowRayCount, light.position(), settings().lightSize);
        while (points.next()) {
            const Vector3 towards = points.get() - start;
            const auto hit = scene.findClosestIntersection({start, towards.normalised()});
            reached += !hit || hit->distance > towards.magnitude();
        }
        colour += (diffuse + specular) * (reached / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin

        const Ray ray = camera.castRay(x, y);
        const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        ColourRGB sum;
        auto points = lensPoints(settings().dofRayCount, settings().dofAmount);
        while (points.next()) sum += trace(scene, {points.get(), (focus - points.get()).normalised()}, settings().bounces);
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
