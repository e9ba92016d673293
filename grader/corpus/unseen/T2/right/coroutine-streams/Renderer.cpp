// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <coroutine>
#include <exception>
#include <numbers>
#include <utility>
#include <vector>

namespace raytracer {
namespace {

template <class T>
class Stream {
public:
    struct promise_type {
        T current{};
        Stream get_return_object() {
            return Stream{std::coroutine_handle<promise_type>::from_promise(*this)};
        }
        std::suspend_always initial_suspend() noexcept { return {}; }
        std::suspend_always final_suspend() noexcept { return {}; }
        std::suspend_always yield_value(const T& value) {
            current = value;
            return {};
        }
        void return_void() {}
        void unhandled_exception() { std::terminate(); }
    };
    explicit Stream(std::coroutine_handle<promise_type> handle) : handle_(handle) {}
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;
    ~Stream() { handle_.destroy(); }

    bool advance() {
        handle_.resume();
        return !handle_.done();
    }
    const T& value() const { return handle_.promise().current; }

private:
    std::coroutine_handle<promise_type> handle_;
};

Stream<Vector3> aimPoints(Vector3 centre, double radius, int count) {
    while (count > 0) {
        const double x = randomBetween(-1.0, 1.0);
        const double y = randomBetween(-1.0, 1.0);
        const double z = randomBetween(-1.0, 1.0);
        const Vector3 candidate{x, y, z};
        if (candidate.dot(candidate) > 1.0) continue;
        --count;
        co_yield centre + candidate * radius;
    }
}

Stream<Vector3> lensPoints(double half, int count) {
    std::vector<int> column(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        column[static_cast<std::size_t>(i)] = i;
    for (int i = count - 1; i > 0; --i) {
        const int j = static_cast<int>(randomBetween(0.0, i + 1.0));
        std::swap(column[static_cast<std::size_t>(i)], column[static_cast<std::size_t>(j)]);
    }
    const double cell = 2.0 * half / count;
    for (int i = 0; i < count; ++i) {
        const double x = -half + cell * (i + randomBetween(0.0, 1.0));
        const double y = -half + cell * (column[static_cast<std::size_t>(i)] + randomBetween(0.0, 1.0));
        co_yield Vector3{x, y, 0.0};
    }
}

}  // namespace

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
        double arrived = 0.0;
        auto aims = aimPoints(light.position(), settings().lightSize, settings().shadowRayCount);
        while (aims.advance()) {
            const Vector3 way = aims.value() - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way});
            if (!hit || hit->distance >= 1.0) arrived += 1.0;  // in lengths of `way`
        }
        colour += (diffuse + specular) * (arrived / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray straight = camera.castRay(x, y);
        const Vector3 focus = straight.direction * (settings().dofFocalPlane / straight.direction.z);
        ColourRGB total;
        auto lens = lensPoints(settings().dofAmount, settings().dofRayCount);
        while (lens.advance()) {
            const Vector3 from = straight.origin + lens.value();
            total += trace(scene, Ray{from, (focus - from).normalised()}, settings().bounces);
        }
        image.set(x, y, total / static_cast<double>(settings().dofRayCount));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
