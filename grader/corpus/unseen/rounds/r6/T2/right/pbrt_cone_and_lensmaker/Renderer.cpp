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
namespace {

/// Two unit vectors at right angles to w and to each other.
std::pair<Vector3, Vector3> basisAround(const Vector3& w) {
    const Vector3 a = std::abs(w.x) < 0.7 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
    const Vector3 s = w.cross(a).normalised();
    return {s, w.cross(s)};
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
        // PBRT, "Sampling light sources: sphere": uniform directions in the cone that it fills.
        const Vector3 start = P + N * kShadowBias;
        const double R = settings().lightSize;
        const Vector3 axis = light.position() - start;
        const double dc = axis.magnitude();
        const Vector3 wc = axis / dc;
        const auto [wx, wy] = basisAround(wc);
        int visible = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            Vector3 dir;
            double reach;
            if (dc <= 1.0001 * R) {  // inside of the light
                const Vector3 way = axis + Vector3::randomInsideUnitSphere() * R;
                reach = way.magnitude();
                dir = way / reach;
            } else {
                const double cosThetaMax = std::sqrt(1.0 - (R * R) / (dc * dc));
                const double cosTheta = 1.0 - randomBetween(0.0, 1.0) * (1.0 - cosThetaMax);
                const double sin2Theta = std::max(0.0, 1.0 - cosTheta * cosTheta);
                const double sinTheta = std::sqrt(sin2Theta);
                const double phi = randomBetween(0.0, 2.0 * std::numbers::pi);
                dir = wx * (sinTheta * std::cos(phi)) + wy * (sinTheta * std::sin(phi)) + wc * cosTheta;
                reach = dc * cosTheta - std::sqrt(std::max(0.0, R * R - dc * dc * sin2Theta));
            }
            const auto hit = scene.findClosestIntersection(Ray{start, dir});
            if (!hit || hit->distance > reach) ++visible;
        }
        colour += (diffuse + specular) * (double(visible) / settings().shadowRayCount);
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
