// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace raytracer {
namespace {

std::mt19937_64& engine() {
    thread_local std::mt19937_64 e{std::random_device{}()};
    return e;
}

constexpr int kRanks[8][8] = {
    {0, 32, 8, 40, 2, 34, 10, 42},  {48, 16, 56, 24, 50, 18, 58, 26},
    {12, 44, 4, 36, 14, 46, 6, 38}, {60, 28, 52, 20, 62, 30, 54, 22},
    {3, 35, 11, 43, 1, 33, 9, 41},  {51, 19, 59, 27, 49, 17, 57, 25},
    {15, 47, 7, 39, 13, 45, 5, 37}, {63, 31, 55, 23, 61, 29, 53, 21}};

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
        std::uniform_real_distribution<double> side{-1.0, 1.0};
        const Vector3 from = P + toLight * kShadowBias;
        int through = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            double a, b, c;
            do {
                a = side(engine());
                b = side(engine());
                c = side(engine());
            } while (a * a + b * b + c * c > 1.0);
            const Vector3 aim = light.position() + Vector3{a, b, c} * settings().lightSize;
            const Ray shadowRay{from, (aim - from).normalised()};
            const auto hit = scene.findClosestIntersection(shadowRay);
            if (hit && hit->distance < (aim - from).magnitude()) continue;
            ++through;
        }
        const auto share = static_cast<double>(through) / static_cast<double>(settings().shadowRayCount);
        colour += diffuse * share + specular * share;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        std::uniform_real_distribution<double> unit{0.0, 1.0};
        const Ray ray = camera.castRay(x, y);
        const Vector3 focal = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        const double shiftX = (kRanks[y & 7][x & 7] + unit(engine())) / 64.0;
        const double shiftY = (kRanks[(x + 3) & 7][(y + 5) & 7] + unit(engine())) / 64.0;
        const int n = settings().dofRayCount;
        ColourRGB sum;
        for (int i = 0; i < n; ++i) {
            // Rank-1 lattice by the golden ratio.
            const double u = std::fmod(shiftX + (i + unit(engine())) / n, 1.0);
            const double v = std::fmod(shiftY + i * 0.6180339887498949, 1.0);
            const Vector3 lens{settings().dofAmount * (2.0 * u - 1.0), settings().dofAmount * (2.0 * v - 1.0), 0.0};
            sum += trace(scene, Ray{lens, (focal - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum * (1.0 / n));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
