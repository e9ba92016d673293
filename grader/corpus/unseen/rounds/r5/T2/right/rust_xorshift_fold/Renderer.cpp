// Rust semantics: fold, map_or, an Rng that is passed along by value
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>

namespace raytracer {

namespace {

using u64 = std::uint64_t;
using f64 = double;

/// xorshift64*, seeded from the kit's generator so that pictures repeat under a seed
struct Rng {
    u64 state;
    static Rng seeded() {
        const u64 hi = static_cast<u64>(randomBetween(0.0, 4294967296.0));
        const u64 lo = static_cast<u64>(randomBetween(0.0, 4294967296.0));
        return Rng{(hi << 32 | lo) | 1};
    }
    u64 next() {
        state ^= state >> 12;
        state ^= state << 25;
        state ^= state >> 27;
        return state * 0x2545F4914F6CDD1DULL;
    }
    f64 unit() { return static_cast<f64>(next() >> 11) / 9007199254740992.0; }
    f64 signedUnit() { return 2.0 * unit() - 1.0; }
    Vector3 ball() {
        for (;;) {
            const f64 x = signedUnit();
            const f64 y = signedUnit();
            const f64 z = signedUnit();
            if (x * x + y * y + z * z < 1.0) return {x, y, z};
        }
    }
};

template <typename T, typename F>
T fold(int n, T init, F f) {
    return n == 0 ? init : fold(n - 1, f(init), f);
}

template <typename O, typename D, typename F>
D map_or(const O& option, D fallback, F f) {
    return option ? f(*option) : fallback;
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
        Rng rng = Rng::seeded();
        const Vector3 origin = P + N * kShadowBias;
        const int n = settings().shadowRayCount;
        const int arrived = fold(n, 0, [&](int acc) {
            const Vector3 path = light.position() + rng.ball() * settings().lightSize - origin;
            const auto hit = scene.findClosestIntersection(Ray{origin, path.normalised()});
            return acc + map_or(hit, 1, [&](const RaycastHit& h) { return h.distance < path.magnitude() ? 0 : 1; });
        });
        colour += (diffuse + specular) * (static_cast<f64>(arrived) / static_cast<f64>(n));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        Rng rng = Rng::seeded();
        const Ray central = camera.castRay(x, y);
        const Vector3 focal = central.evaluateAt(settings().dofFocalPlane / central.direction.z);
        const ColourRGB sum = fold(settings().dofRayCount, ColourRGB{}, [&](ColourRGB acc) {
            const f64 dx = rng.signedUnit() * settings().dofAmount;
            const f64 dy = rng.signedUnit() * settings().dofAmount;
            const Vector3 eye{dx, dy, 0.0};
            return acc + trace(scene, Ray{eye, (focal - eye).normalised()}, settings().bounces);
        });
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
