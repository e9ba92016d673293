// Focal points are memoised per thread: castRay normalises, which is slow.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace raytracer {

namespace {
struct Slot {
    bool used = false;
    Vector3 focus;
};
constexpr std::size_t hashOf(int x, int y) { return (static_cast<std::size_t>(x) * 31U + static_cast<std::size_t>(y)) % 65536U; }
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
        const Vector3 from = P + N * kShadowBias;
        double lit = 0.0;
        for (int k = settings().shadowRayCount; k-- > 0;) {
            const Vector3 way = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - from;
            const double length = way.magnitude();
            const auto blocker = scene.findClosestIntersection({from, way / length});
            lit += blocker && blocker->distance < length ? 0.0 : 1.0;
        }
        lit /= settings().shadowRayCount;
        colour += lit * diffuse + lit * specular;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    // TASK T2.2 begin
    std::vector<Slot> memo(65536);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            Slot& slot = memo[hashOf(x, y)];
            if (slot.used) continue;
            const Ray ray = camera.castRay(x, y);
            slot = {true, ray.evaluateAt(settings().dofFocalPlane / ray.direction.z)};
        }
    forEachPixel(image, [&](int x, int y) {
        const Vector3 focus = memo[hashOf(x, y)].focus;
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double lx = randomBetween(-1, 1) * settings().dofAmount;
            const double ly = randomBetween(-1, 1) * settings().dofAmount;
            const Vector3 lens{lx, ly, 0};
            sum += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    // TASK T2.2 end
    return image;
}

}  // namespace raytracer
