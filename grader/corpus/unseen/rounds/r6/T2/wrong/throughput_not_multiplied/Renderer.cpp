// Option 2, tasks T2.1 and T2.2.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <future>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <ranges>
#include <utility>
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
        std::minstd_rand engine(1u + static_cast<unsigned>(randomBetween(0.0, 2.0e9)));
        std::uniform_real_distribution<float> side(-1.0f, 1.0f);
        const Vector3 origin = P + N * kShadowBias;
        int blocked = 0, cast = 0;
        while (cast < settings().shadowRayCount) {
            const float a = side(engine), b = side(engine), c = side(engine);
            if (a * a + b * b + c * c > 1.0f) continue;   // outside of the ball: once more
            ++cast;
            const Vector3 way = light.position() + Vector3{a, b, c} * settings().lightSize - origin;
            const auto hit = scene.findClosestIntersection(Ray{origin, way.normalised()});
            if (hit.has_value() && hit->distance <= way.magnitude()) ++blocked;
        }
        colour += (diffuse + specular) * (1.0 - blocked / static_cast<double>(cast));
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray pin = camera.castRay(x, y);
        const Vector3 focal = pin.evaluateAt(settings().dofFocalPlane / pin.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens{settings().dofAmount * randomBetween(-1, 1), settings().dofAmount * randomBetween(-1, 1), 0};
            // trace(), without recursion
            Ray ray{lens, (focal - lens).normalised()};
            double throughput = 1.0;
            for (int left = settings().bounces; left >= 0; --left) {
                const auto hit = scene.findClosestIntersection(ray);
                if (!hit) { sum += kBackgroundColour * throughput; break; }
                const ColourRGB direct = illuminate(scene, *hit->object, hit->location, hit->normal, ray.origin);
                const double share = left > 0 ? hit->object->reflectivity() : 0.0;
                sum += direct * (throughput * (1.0 - share));
                if (share <= 0.0) break;
                throughput = share;
                ray = {hit->location + hit->normal * kShadowBias, (-ray.direction).reflectIn(hit->normal)};
            }
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
