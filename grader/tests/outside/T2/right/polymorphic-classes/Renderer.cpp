#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <functional>
#include <memory>
#include <vector>

namespace raytracer {

namespace {
struct Sampler { virtual ~Sampler() = default; virtual Vector3 next() = 0; };
struct Ball final : Sampler {
    Vector3 centre; double radius;
    Ball(Vector3 c, double r) : centre(c), radius(r) {}
    Vector3 next() override { return centre + radius * Vector3::randomInsideUnitSphere(); }
};
struct Square final : Sampler {
    double half;
    explicit Square(double h) : half(h) {}
    Vector3 next() override { const double a = randomBetween(-half, half); return {a, randomBetween(-half, half), 0}; }
};
class Mean {
public:
    explicit Mean(int n) : n_(n) {}
    template <typename F> ColourRGB of(F f) const {
        std::vector<ColourRGB> all;
        for (int i = 0; i < n_; ++i) all.push_back(f());
        std::function<ColourRGB(std::size_t, std::size_t)> sum = [&](std::size_t a, std::size_t b) {
            return b - a == 1 ? all[a] : sum(a, (a + b) / 2) + sum((a + b) / 2, b);
        };
        return sum(0, all.size()) / n_;
    }
private:
    int n_;
};
}

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 V = (O - P).normalised();
    std::function<ColourRGB(std::size_t)> from = [&](std::size_t i) -> ColourRGB {
        if (i == scene.pointLights().size()) return object.colour() * scene.ambientLighting();
        const PointLight& light = scene.pointLights()[i];
        std::unique_ptr<Sampler> ball = std::make_unique<Ball>(light.position(), settings().lightSize);
        const ColourRGB here = Mean(settings().shadowRayCount).of([&]() -> ColourRGB {
            const Vector3 target = ball->next(), start = P + N * kShadowBias;
            const Vector3 L = (target - P).normalised();
            const auto hit = scene.findClosestIntersection(Ray(start, (target - start).normalised()));
            if (hit && hit->distance < (target - start).magnitude()) return {};
            const ColourRGB I = light.illuminationAt((target - P).magnitude());
            return object.colour() * I * (object.phongKD() * std::max(0., N.dot(L))) +
                   light.colour() * I * (object.phongKS() * std::pow(std::max(0., L.reflectIn(N).dot(V)), object.phongAlpha()));
        });
        return here + from(i + 1);
    };
    return from(0);
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray r = camera.castRay(x, y);
        const Vector3 focus = r.direction * (settings().dofFocalPlane / r.direction.z);
        Square square(settings().dofAmount / 2);
        image.set(x, y, Mean(settings().dofRayCount).of([&] {
            const Vector3 o = square.next();
            return trace(scene, Ray(o, (focus - o).normalised()), settings().bounces);
        }));
    });
    return image;
}

}  // namespace raytracer
