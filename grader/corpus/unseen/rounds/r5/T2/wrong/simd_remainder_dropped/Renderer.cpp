// Shadow rays in packets of four.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {
constexpr int kWidth = 4;
struct Packet {
    std::array<Vector3, kWidth> ways;
    template <class F> static Packet generate(F f) {
        Packet p;
        for (auto& w : p.ways) w = f();
        return p;
    }
    [[nodiscard]] int arriving(const Scene& scene, const Vector3& start) const {
        int mask = 0;
        for (int lane = 0; lane < kWidth; ++lane) {
            const auto hit = scene.findClosestIntersection({start, ways[lane].normalised()});
            mask |= (!hit || hit->distance > ways[lane].magnitude()) << lane;
        }
        return __builtin_popcount(mask);
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
        const Vector3 start = P + N * kShadowBias;
        int reached = 0;
        for (int packet = 0; packet < settings().shadowRayCount / kWidth; ++packet)
            reached += Packet::generate([&] {
                           return light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
                       }).arriving(scene, start);
        colour += (diffuse + specular) * (static_cast<double>(reached) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray through = camera.castRay(x, y);
        const Vector3 focus = through.evaluateAt(settings().dofFocalPlane / through.direction.z);
        ColourRGB total;
        for (int i = 0; i < settings().dofRayCount; i++) {
            const double a = settings().dofAmount;
            const Vector3 eye(randomBetween(-1, 1) * a, randomBetween(-1, 1) * a, 0);
            total += trace(scene, Ray(eye, (focus - eye).normalised()), settings().bounces);
        }
        image.set(x, y, total / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
