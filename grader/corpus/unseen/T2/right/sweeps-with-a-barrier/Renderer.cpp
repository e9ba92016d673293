#include <raytracer/base/RenderObserver.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <barrier>
#include <cmath>
#include <thread>
#include <vector>

namespace raytracer {

namespace {
struct Phong {
    ColourRGB diffuse, specular;
};

Phong phong(const SceneObject& what, const PointLight& lamp, const Vector3& P, const Vector3& N, const Vector3& V) {
    const Vector3 gap = lamp.position() - P;
    const Vector3 L = gap.normalised();
    const ColourRGB I = lamp.illuminationAt(gap.magnitude());
    const double nl = N.dot(L), rv = L.reflectIn(N).dot(V);
    Phong p;
    if (nl > 0) p.diffuse = what.colour() * I * what.phongKD() * nl;
    if (rv > 0) p.specular = lamp.colour() * I * what.phongKS() * std::pow(rv, what.phongAlpha());
    return p;
}
}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    ColourRGB out = scene.ambientLighting() * object.colour();
    const Vector3 V = (O - P).normalised();
    for (const auto& lamp : scene.pointLights()) {
        // TASK T2.1 begin
        int through = 0;
        for (int k = 0; k < settings().shadowRayCount; ++k) {
            const Vector3 somewhere = lamp.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const Vector3 start = P + N * kShadowBias;
            const auto hit = scene.findClosestIntersection({start, (somewhere - start).normalised()});
            through += !hit || hit->distance > (somewhere - start).magnitude();
        }
        const auto [diffuse, specular] = phong(object, lamp, P, N, V);
        out += (diffuse + specular) * (double(through) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return out;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    // TASK T2.2 begin
    // One sweep over the picture for each ray; no thread begins the next before all have finished.
    const int workers = std::max(1, settings().threads);
    const int width = image.width(), height = image.height();
    std::vector<ColourRGB> sums(std::size_t(width) * std::size_t(height));
    std::barrier sweepDone{workers};
    const auto sweep = [&](int me) {
        for (int pass = 0; pass < settings().dofRayCount; ++pass) {
            for (int y = me; y < height; y += workers) {
                seedRandom(settings().seed * 1000003U + std::uint64_t(pass) * 65536U + std::uint64_t(y));
                for (int x = 0; x < width; ++x) {
                    const Ray eye = camera.castRay(x, y);
                    const Vector3 focus = eye.evaluateAt(settings().dofFocalPlane / eye.direction.z);
                    const Vector3 lens{randomBetween(-1, 1) * settings().dofAmount,
                                       randomBetween(-1, 1) * settings().dofAmount, 0};
                    sums[std::size_t(y) * std::size_t(width) + std::size_t(x)] +=
                        trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
                }
            }
            sweepDone.arrive_and_wait();
        }
        for (int y = me; y < height; y += workers)
            for (int x = 0; x < width; ++x)
                image.set(x, y, sums[std::size_t(y) * std::size_t(width) + std::size_t(x)] / settings().dofRayCount);
    };
    {
        std::vector<std::jthread> team;
        for (int i = 1; i < workers; ++i)
            team.emplace_back(sweep, i);
        sweep(0);
    }
    // TASK T2.2 end
    return image;
}

}  // namespace raytracer
