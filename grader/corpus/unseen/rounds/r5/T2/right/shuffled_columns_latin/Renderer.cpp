// Latin hypercube samples: each row, column and shell of the domain is used once.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace raytracer {

namespace {

/// n numbers in [0, 1), one in each n-th, in random order.
std::vector<double> column(int n) {
    std::vector<double> c(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) c[i] = (i + randomBetween(0.0, 1.0)) / n;
    for (int i = n - 1; i > 0; --i) std::swap(c[i], c[static_cast<int>(randomBetween(0.0, i + 1.0))]);
    return c;
}

template <std::size_t D>
struct LatinHypercube {
    std::array<std::vector<double>, D> columns;
    explicit LatinHypercube(int n) {
        for (auto& c : columns) c = column(n);
    }
};

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
        const int n = settings().shadowRayCount;
        const LatinHypercube<3> latin{n};
        const Vector3 from = P + N * kShadowBias;
        std::vector<char> arrived(n);
        for (int i = 0; i < n; ++i) {
            const double h = 2.0 * latin.columns[0][i] - 1.0;
            const double a = 2.0 * std::numbers::pi * latin.columns[1][i];
            const double r = settings().lightSize * std::cbrt(latin.columns[2][i]);
            const double q = std::sqrt(1.0 - h * h);
            const Vector3 aim = light.position() + Vector3{r * q * std::sin(a), r * h, r * q * std::cos(a)};
            const auto hit = scene.findClosestIntersection({from, (aim - from).normalised()});
            arrived[i] = !hit || hit->distance > (aim - from).magnitude();
        }
        colour += (diffuse + specular) * (std::accumulate(arrived.begin(), arrived.end(), 0) / double(n));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const int n = settings().dofRayCount;
        const LatinHypercube<2> latin{n};
        const Ray ray = camera.castRay(x, y);
        const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        ColourRGB sum;
        for (int i = 0; i < n; ++i) {
            const Vector3 eye{settings().dofAmount * (2.0 * latin.columns[0][i] - 1.0),
                              settings().dofAmount * (2.0 * latin.columns[1][i] - 1.0), 0.0};
            sum += trace(scene, {eye, (focus - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / n);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
