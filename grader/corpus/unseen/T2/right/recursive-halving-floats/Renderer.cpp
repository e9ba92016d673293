#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace raytracer {

namespace {

class XorShift {
public:
    explicit XorShift(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ULL + 0x1234567ULL) {
        for (int i = 0; i < 8; ++i)
            next();
    }
    float next() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return static_cast<float>(state_ >> 40) / 16777216.0F;
    }

private:
    std::uint64_t state_;
};

std::uint64_t bitsOf(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

struct Colour {
    float r = 0, g = 0, b = 0;
};

template <class Each>
Colour halved(int from, int to, const Each& each) {
    if (to - from == 1) return each(from);
    const int middle = (from + to) / 2;
    const Colour a = halved(from, middle, each);
    const Colour b = halved(middle, to, each);
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}

}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 eye = (O - P).normalised();
    ColourRGB out = object.colour() * scene.ambientLighting();
    XorShift random{bitsOf(P.x) ^ (bitsOf(P.y) << 1U) ^ (bitsOf(P.z) << 2U) ^ bitsOf(O.x)};
    for (const PointLight& lamp : scene.pointLights()) {
        const Vector3 way = lamp.position() - P;
        const Vector3 L = way.normalised();
        const ColourRGB power = lamp.illuminationAt(way.magnitude());
        ColourRGB direct = object.colour() * power * (object.phongKD() * std::max(0.0, N.dot(L)));
        direct += lamp.colour() * power *
                  (object.phongKS() *
                   std::pow(std::max(0.0, L.reflectIn(N).dot(eye)), object.phongAlpha()));
        const int n = settings().shadowRayCount;
        const Colour open = halved(0, n, [&](int) {
            float x = 0, y = 0, z = 0;
            do {
                x = 2 * random.next() - 1;
                y = 2 * random.next() - 1;
                z = 2 * random.next() - 1;
            } while (x * x + y * y + z * z > 1);
            const Vector3 from = P + N * kShadowBias;
            const Vector3 aim = lamp.position() + Vector3{x, y, z} * settings().lightSize;
            const auto hit = scene.findClosestIntersection({from, (aim - from).normalised()});
            const bool clear = !hit || hit->distance > (aim - from).magnitude();
            return Colour{clear ? 1.0F : 0.0F, 0, 0};
        });
        out += direct * (open.r / static_cast<float>(n));
    }
    return out;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    const int n = settings().dofRayCount;
    for (int y = image.height() - 1; y >= 0; --y)
        for (int x = 0; x < image.width(); ++x) {
            XorShift random{settings().seed + static_cast<std::uint64_t>(y * 70000 + x)};
            const Vector3 d = camera.castRay(x, y).direction;
            const Vector3 sharp = d * (settings().dofFocalPlane / d.z);
            const Colour sum = halved(0, n, [&](int) {
                const float u = 2 * random.next() - 1;
                const float v = 2 * random.next() - 1;
                const Vector3 lens{u * settings().dofAmount, v * settings().dofAmount, 0.0};
                const ColourRGB c =
                    trace(scene, {lens, (sharp - lens).normalised()}, settings().bounces);
                return Colour{static_cast<float>(c.r), static_cast<float>(c.g),
                              static_cast<float>(c.b)};
            });
            const auto count = static_cast<float>(n);
            image.set(x, y, ColourRGB{sum.r / count, sum.g / count, sum.b / count});
        }
    return image;
}

}  // namespace raytracer
