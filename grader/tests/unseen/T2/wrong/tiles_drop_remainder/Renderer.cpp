// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <atomic>
#include <thread>
#include <vector>

namespace raytracer {

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
        int blocked = 0;
        for (int k = 0; k != settings().shadowRayCount; ++k) {
            Vector3 offset = Vector3::randomInsideUnitSphere();
            offset *= settings().lightSize;
            const Vector3 origin = P + kShadowBias * N;
            const Vector3 d = light.position() + offset - origin;
            const double reach = d.magnitude();
            if (const auto h = scene.findClosestIntersection({origin, d / reach}); h && h->distance < reach) ++blocked;
        }
        colour += (diffuse + specular) * (1.0 - static_cast<double>(blocked) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    // TASK T2.2 begin
    constexpr int kTile = 8;
    const int tilesX = image.width() / kTile;
    const int tilesY = image.height() / kTile;
    std::atomic<int> nextTile{0};

    const auto pixel = [&](int x, int y) {
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 focus = d * (settings().dofFocalPlane / d.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens{settings().dofAmount * randomBetween(-1.0, 1.0),
                               settings().dofAmount * randomBetween(-1.0, 1.0), 0.0};
            sum += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    };
    const auto worker = [&] {
        for (int tile = nextTile++; tile < tilesX * tilesY; tile = nextTile++)
            for (int k = 0; k < kTile * kTile; ++k)
                pixel(tile % tilesX * kTile + k % kTile, tile / tilesX * kTile + k / kTile);
    };
    std::vector<std::jthread> threads;
    for (int i = 1; i < settings().threads; ++i) threads.emplace_back(worker);
    worker();
    threads.clear();  // joins
    // TASK T2.2 end
    return image;
}

}  // namespace raytracer
