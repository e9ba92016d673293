#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <future>
#include <random>
#include <vector>

namespace raytracer {

namespace {

std::mt19937_64& engine() {
    thread_local std::mt19937_64 own{std::random_device{}()};
    return own;
}

std::uint32_t corput(std::uint32_t n) {
    std::uint32_t r = 0;
    for (int bit = 31; n != 0; n >>= 1, --bit)
        if (n & 1U) r |= 1U << bit;
    return r;
}

std::uint32_t sobol2(std::uint32_t n) {
    std::uint32_t r = 0;
    for (std::uint32_t v = 1U << 31; n != 0; n >>= 1, v ^= v >> 1)
        if (n & 1U) r ^= v;
    return r;
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
        const int n = settings().shadowRayCount;
        std::uniform_real_distribution<double> unit{-1.0, 1.0};
        Vector3 last;
        for (int i = 0; i < n; ++i) {
            if (i % 2 == 0) {
                do
                    last = {unit(engine()), unit(engine()), unit(engine())};
                while (last.magnitude() > 1.0);
            } else {
                last = -last;
            }
            const Vector3 from = P + N * kShadowBias;
            const Vector3 aim = lamp.position() + last * settings().lightSize;
            const auto hit = scene.findClosestIntersection({from, (aim - from).normalised()});
            if (!hit || hit->distance > (aim - from).magnitude()) ++open;
        }
        out += direct * (static_cast<double>(open) / n);
    }
    return out;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    const double A = settings().dofAmount;
    std::vector<std::future<std::vector<ColourRGB>>> rows;
    for (int y = 0; y < image.height(); ++y)
        rows.push_back(std::async(std::launch::async, [&, y] {
            std::vector<ColourRGB> line;
            for (int x = 0; x < image.width(); ++x) {
                const Ray through = camera.castRay(x, y);
                const Vector3 sharp =
                    through.direction * (settings().dofFocalPlane / through.direction.z);
                const auto shiftX = static_cast<std::uint32_t>(engine()());
                const auto shiftY = static_cast<std::uint32_t>(engine()());
                ColourRGB sum;
                for (int i = 0; i < settings().dofRayCount; ++i) {
                    const auto n = static_cast<std::uint32_t>(i);
                    const double u = (corput(n) ^ shiftX) / 4294967296.0;
                    const double v = (sobol2(n) ^ shiftY) / 4294967296.0;
                    const Vector3 lens{A * (2.0 * u - 1.0), A * (2.0 * v - 1.0), 0.0};
                    sum += trace(scene, {lens, (sharp - lens).normalised()}, settings().bounces);
                }
                line.push_back(sum / settings().dofRayCount);
            }
            return line;
        }));
    for (int y = 0; y < image.height(); ++y) {
        const std::vector<ColourRGB> line = rows[static_cast<std::size_t>(y)].get();
        for (int x = 0; x < image.width(); ++x)
            image.set(x, y, line[static_cast<std::size_t>(x)]);
    }
    return image;
}

}  // namespace raytracer
