// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace raytracer {
namespace {

/// A random order of 0 .. n - 1, from the kit's generator.
std::vector<int> shuffled(int n) {
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    for (int i = n - 1; i > 0; --i) {
        const int j = std::min(i, static_cast<int>(randomBetween(0.0, i + 1.0)));
        std::swap(order[static_cast<std::size_t>(i)], order[static_cast<std::size_t>(j)]);
    }
    return order;
}

/// n numbers in [low, high), one in each of n equal slices, in a random order.
std::vector<double> stratified(int n, double low, double high) {
    std::vector<double> numbers;
    numbers.reserve(static_cast<std::size_t>(n));
    for (const int slice : shuffled(n))
        numbers.push_back(low + (high - low) * (slice + randomBetween(0.0, 1.0)) / n);
    return numbers;
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
        const int n = settings().shadowRayCount;
        const auto volume = stratified(n, 0.0, 1.0);
        const auto height = stratified(n, -1.0, 1.0);
        const auto turn = stratified(n, 0.0, 2.0 * std::numbers::pi);
        int reached = 0;
        for (std::size_t i = 0; i < volume.size(); ++i) {
            const double ring = std::sqrt(std::max(0.0, 1.0 - height[i] * height[i]));
            const Vector3 inBall = Vector3{ring * std::cos(turn[i]), height[i], ring * std::sin(turn[i])} * std::cbrt(volume[i]);
            const Vector3 target = light.position() + inBall * settings().lightSize;
            const Vector3 origin = P + N * kShadowBias;
            const auto blocker = scene.findClosestIntersection({origin, (target - origin).normalised()});
            if (blocker && blocker->distance <= (target - origin).magnitude()) continue;
            ++reached;
        }
        colour += (diffuse + specular) * static_cast<double>(reached) / n;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray eyeRay = camera.castRay(x, y);
        const Vector3 focus = eyeRay.evaluateAt(settings().dofFocalPlane / eyeRay.direction.z);
        const auto xs = stratified(settings().dofRayCount, -settings().dofAmount, settings().dofAmount);
        const auto ys = stratified(settings().dofRayCount, -settings().dofAmount, settings().dofAmount);
        const ColourRGB sum = std::inner_product(
            xs.begin(), xs.end(), ys.begin(), ColourRGB{}, std::plus<>{}, [&](double lx, double ly) {
                const Vector3 lens{lx, ly, 0.0};
                return trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
            });
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
