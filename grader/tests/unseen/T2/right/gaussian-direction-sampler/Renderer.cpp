#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <cmath>
#include <random>

namespace raytracer {
namespace {
class LampSampler {
public:
    LampSampler(const Vector3& centre, double radius) : centre_(centre), radius_(radius) {}
    Vector3 operator()() const {
        const Vector3 g{normal_(engine()), normal_(engine()), normal_(engine())};
        return centre_ + g.normalised() * (radius_ * std::cbrt(unit_(engine())));
    }
    static std::minstd_rand& engine() {
        thread_local std::minstd_rand e{std::random_device{}()};
        return e;
    }

private:
    Vector3 centre_;
    double radius_;
    mutable std::normal_distribution<double> normal_;
    mutable std::uniform_real_distribution<double> unit_;
};

struct Shading {
    const SceneObject& object;
    const PointLight& light;
    Vector3 P, N, V;
    ColourRGB operator()() const {
        const Vector3 w = light.position() - P;
        const Vector3 L = w.normalised();
        const ColourRGB I = light.illuminationAt(w.magnitude());
        // R.V = 2 (N.L)(N.V) - L.V
        const double rv = 2 * N.dot(L) * N.dot(V) - L.dot(V);
        const double spec =
            rv > 0 ? object.phongKS() * std::exp(object.phongAlpha() * std::log(rv)) : 0;
        return I * object.colour() * object.phongKD() * std::max(0.0, N.dot(L)) +
               I * light.colour() * spec;
    }
};
}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    ColourRGB colour = object.colour() * scene.ambientLighting();
    for (const PointLight& light : scene.pointLights()) {
        const LampSampler lamp{light.position(), settings().lightSize};
        int misses = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 to = lamp();
            const Vector3 L = (to - P).normalised();
            const Ray ray{P + L * 1e-5, L};
            if (const auto hit = scene.findClosestIntersection(ray);
                hit && hit->distance + 1e-5 < (to - P).magnitude())
                ++misses;
        }
        const ColourRGB all = Shading{object, light, P, N, (O - P).normalised()}();
        colour += all - all * (static_cast<double>(misses) / settings().shadowRayCount);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    std::vector<std::vector<ColourRGB>> sums(
        static_cast<std::size_t>(image.height()),
        std::vector<ColourRGB>(static_cast<std::size_t>(image.width())));
    // One whole picture after the other, each through another point of the lens for every pixel.
    std::uniform_real_distribution<double> side(-0.5, 0.5);
    for (int pass = 0; pass < settings().dofRayCount; ++pass)
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const Ray ray = camera.castRay(x, y);
                const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
                const double lx = side(LampSampler::engine()) * settings().dofAmount;
                const double ly = side(LampSampler::engine()) * settings().dofAmount;
                const Vector3 from{lx, ly, 0};
                sums[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] +=
                    trace(scene, {from, (focus - from).normalised()}, settings().bounces);
            }
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            image.set(x, y,
                      sums[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] /
                          settings().dofRayCount);
    return image;
}
}  // namespace raytracer
