#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace raytracer {

static std::vector<int> shuffled(int n, std::mt19937& g) {
    std::vector<int> v(n);
    for (int i = 0; i < n; ++i) v[i] = i;
    std::shuffle(v.begin(), v.end(), g);
    return v;
}
static thread_local std::mt19937 gen(std::random_device{}());
static double u01() { return std::uniform_real_distribution<>(0, 1)(gen); }

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

        const int n = settings().shadowRayCount;
        const auto a = shuffled(n, gen), b = shuffled(n, gen), c = shuffled(n, gen);
        double lit = 0;
        for (int i = 0; i < n; ++i) {
            const double radius = settings().lightSize * std::cbrt((a[i] + u01()) / n);
            const double z = 2 * (b[i] + u01()) / n - 1, phi = 2 * std::numbers::pi * (c[i] + u01()) / n;
            const double q = std::sqrt(1 - z * z);
            const Vector3 way = light.position() + Vector3(q * std::cos(phi), q * std::sin(phi), z) * radius - P;
            const auto hit = scene.findClosestIntersection(Ray(P + N * 1e-4, way));  // not normalised: 1 is the light
            lit += !hit || hit->distance > 1 ? 1 : 0;
        }
        colour += (diffuse + specular) * (lit / n);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const int n = settings().dofRayCount;
        const auto a = shuffled(n, gen), b = shuffled(n, gen);
        const Ray middle = camera.castRay(x, y);
        const double f = settings().dofFocalPlane;
        const Vector3 focus{middle.direction.x / middle.direction.z * f, middle.direction.y / middle.direction.z * f, f};
        ColourRGB mean;
        for (int i = 0; i < n; ++i) {
            const Vector3 from{((a[i] + u01()) / n - 0.5) * settings().dofAmount, ((b[i] + u01()) / n - 0.5) * settings().dofAmount, 0};
            mean = mean + (trace(scene, {from, (focus - from).normalised()}, settings().bounces) - mean) / (i + 1);
        }
        image.set(x, y, mean);
    });
    return image;
}

}  // namespace raytracer
