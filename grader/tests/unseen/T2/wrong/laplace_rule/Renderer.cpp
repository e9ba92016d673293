// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

/// The rule of succession: a better estimate of a probability from few trials than hits / trials.
struct BetaEstimate {
    int hits = 0, trials = 0;
    void observe(bool hit) {
        hits += hit;
        ++trials;
    }
    [[nodiscard]] double mean() const { return (hits + 1.0) / (trials + 2.0); }
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
        BetaEstimate visible;
        const Vector3 start = P + N * kShadowBias;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 way = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere() - start;
            const double length = way.magnitude();
            const auto hit = scene.findClosestIntersection({start, way / length});
            visible.observe(!hit || hit->distance > length);
        }
        colour += (diffuse + specular) * visible.mean();
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray central = camera.castRay(x, y);
        const double t = (settings().dofFocalPlane - central.origin.z) / central.direction.z;
        const Vector3 F = central.origin + t * central.direction;
        const auto lensRay = [&] {
            Vector3 o = central.origin;
            o.x += settings().dofAmount * randomBetween(-1, 1);
            o.y += settings().dofAmount * randomBetween(-1, 1);
            return Ray{o, (F - o).normalised()};
        };
        ColourRGB total;
        int rays = settings().dofRayCount;
        while (rays-- > 0) total += trace(scene, lensRay(), settings().bounces);
        image.set(x, y, total * (1.0 / settings().dofRayCount));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
