// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace raytracer {
namespace {

struct Lens {
    std::vector<double> x, y, dx, dy, dz;
    void draw(std::size_t n, double half) {
        for (auto* column : {&x, &y, &dx, &dy, &dz})
            column->resize(n);
        for (double& a : x)
            a = randomBetween(-half, half);
        for (double& a : y)
            a = randomBetween(-half, half);
    }
};

struct Turn {
    Vector3 v;
    double w;
    Vector3 apply(const Vector3& p) const { return p + 2.0 * v.cross(v.cross(p) + w * p); }
};

/// A uniformly random rotation (Marsaglia 1972).
Turn randomTurn() {
    double a, b, c, d, first, second;
    do {
        a = randomBetween(-1, 1);
        b = randomBetween(-1, 1);
        first = a * a + b * b;
    } while (first >= 1.0);
    do {
        c = randomBetween(-1, 1);
        d = randomBetween(-1, 1);
        second = c * c + d * d;
    } while (second >= 1.0 || second == 0.0);
    const double k = std::sqrt((1.0 - first) / second);
    return {{a, b, c * k}, d * k};
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
        const Turn turn = randomTurn();
        const Vector3 start = P + N * kShadowBias;
        const int n = settings().shadowRayCount;
        // One step of the golden angle, as a complex number.
        constexpr double kStepRe = -0.7373688780783197;
        constexpr double kStepIm = 0.6754902942615238;
        double re = 1.0;
        double im = 0.0;
        int arrived = 0;
        for (int i = 0; i < n; ++i) {
            const double z = 1.0 - (2.0 * i + 1.0) / n;
            const double r = std::sqrt(1.0 - z * z);
            const Vector3 place = light.position() + turn.apply({r * re, r * im, z}) * settings().lightSize;
            const Vector3 way = place - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
            if (!hit || hit->distance > way.magnitude()) ++arrived;
            const double next = re * kStepRe - im * kStepIm;
            im = re * kStepIm + im * kStepRe;
            re = next;
        }
        colour += (diffuse + specular) * (static_cast<double>(arrived) / n);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const std::size_t n = static_cast<std::size_t>(settings().dofRayCount);
        thread_local Lens lens;
        lens.draw(n, settings().dofAmount);

        const Ray ray = camera.castRay(x, y);
        const double k = settings().dofFocalPlane / ray.direction.z;
        const double fx = ray.direction.x * k;
        const double fy = ray.direction.y * k;
        const double fz = settings().dofFocalPlane;
        for (std::size_t i = 0; i < n; ++i) {
            const double dx = fx - lens.x[i];
            const double dy = fy - lens.y[i];
            const double scale = 1.0 / std::sqrt(dx * dx + dy * dy + fz * fz);
            lens.dx[i] = dx * scale;
            lens.dy[i] = dy * scale;
            lens.dz[i] = fz * scale;
        }
        ColourRGB sum;
        for (std::size_t i = 0; i < n; ++i)
            sum += trace(scene, Ray{{lens.x[i], lens.y[i], 0.0}, {lens.dx[i], lens.dy[i], lens.dz[i]}},
                         settings().bounces);
        image.set(x, y, sum / static_cast<double>(n));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
