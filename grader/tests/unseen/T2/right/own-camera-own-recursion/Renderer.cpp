#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace raytracer {
ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 V = (O - P).normalised();
    ColourRGB direct;
    for (const PointLight& light : scene.pointLights()) {
        const Vector3 way = light.position() - P;
        const Vector3 L = way.normalised();
        int lit = 0, cast = 0;
        for (; cast < settings().shadowRayCount; ++cast) {
            const Vector3 target =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 start = P + N * kShadowBias;
            const auto stop = scene.findClosestIntersection({start, (target - start).normalised()});
            const bool dark = stop && (stop->location - start).dot(stop->location - start) <
                                          (target - start).dot(target - start);
            lit += dark ? 0 : 1;
        }
        const ColourRGB I = light.illuminationAt(way.magnitude());
        ColourRGB part = object.colour() * object.phongKD() * std::max(0.0, N.dot(L));
        part += light.colour() * object.phongKS() *
                std::pow(std::max(0.0, L.reflectIn(N).dot(V)), object.phongAlpha());
        direct += part * I * (1.0 * lit / cast);
    }
    return direct + object.colour() * scene.ambientLighting();
}

// The camera and the recursion of the main tick, as I wrote them myself.
Image Renderer::render(const Scene& scene) const {
    Image image{settings()};
    const Region region = settings().region.isWholeFrame() ? Region{} : settings().region;
    const double pixel = 2.0 * std::tan(std::numbers::pi / 8.0) / settings().width;

    const std::function<ColourRGB(const Ray&, int)> follow = [&](const Ray& ray,
                                                                 int left) -> ColourRGB {
        const auto hit = scene.findClosestIntersection(ray);
        if (!hit) return kBackgroundColour;
        const ColourRGB here =
            illuminate(scene, *hit->object, hit->location, hit->normal, ray.origin);
        const double rho = hit->object->reflectivity();
        if (left <= 0 || rho <= 0) return here;
        const Vector3 mirrored = ray.direction - 2 * ray.direction.dot(hit->normal) * hit->normal;
        return here * (1 - rho) +
               rho * follow({hit->location + hit->normal * kShadowBias, mirrored}, left - 1);
    };

    forEachPixel(image, [&](int x, int y) {
        const Vector3 focus = Vector3{(region.x + x - settings().width * 0.5 + 0.5) * pixel,
                                      (settings().height * 0.5 - 0.5 - region.y - y) * pixel, 1.0} *
                              settings().dofFocalPlane;
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens{settings().dofAmount * randomBetween(-1, 1),
                               settings().dofAmount * randomBetween(-1, 1), 0};
            sum += follow({lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}
}  // namespace raytracer
