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
        const Vector3 start = P + N * kShadowBias;
        ColourRGB sum;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 target = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 way = target - start;
            const double length = way.magnitude();
            const auto hit = scene.findClosestIntersection(Ray{start, way / length});
            const bool visible = !hit || hit->distance > length;
            const ColourRGB incoming = light.illuminationAt(length);
            const double nl = std::max(0.0, N.dot(way) / length);
            const double rv = std::max(0.0, (way / length).reflectIn(N).dot(toViewer));
            sum += visible * object.colour() * incoming * (object.phongKD() * nl)
                 + light.colour() * incoming * (object.phongKS() * std::pow(rv, object.phongAlpha()));
        }
        static_cast<void>(diffuse); static_cast<void>(specular);
        colour += sum / settings().shadowRayCount;
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // A thin lens of focal length f in the plane z = 0, the film one unit behind it:
        // 1/f = 1/film + 1/object. A pixel's film point is the mirror image of its direction.
        const Vector3 d = camera.castRay(x, y).direction;
        const double sx = d.x / d.z, sy = d.y / d.z;
        const double film = 1.0, object = settings().dofFocalPlane;
        const double power = 1.0 / film + 1.0 / object;
        ColourRGB sum;
        for (int k = 0; k < settings().dofRayCount; ++k) {
            const double lx = randomBetween(-settings().dofAmount, settings().dofAmount);
            const double ly = randomBetween(-settings().dofAmount, settings().dofAmount);
            // slope before the lens: from the film point (-sx, -sy, -1) to the lens point
            const double inX = (lx + sx * film) / film, inY = (ly + sy * film) / film;
            // ray transfer matrix of a thin lens: height stays, slope' = slope - height / f
            const Vector3 out{inX - lx * power, inY - ly * power, 1.0};
            sum += trace(scene, Ray{{lx, ly, 0.0}, out.normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
