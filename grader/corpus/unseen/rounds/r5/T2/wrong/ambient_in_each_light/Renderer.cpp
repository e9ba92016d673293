// Monoid of colours: each light maps to what it adds, reduce does the rest.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

namespace raytracer {

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 toViewer = (O - P).normalised();
    const ColourRGB ambient = object.colour() * scene.ambientLighting();
    const auto contribution = [&](const PointLight& light) -> ColourRGB {
        const Vector3 path = light.position() - P;
        const ColourRGB arriving = light.illuminationAt(path.magnitude());
        const Vector3 L = path.normalised();
        const ColourRGB diffuse = object.colour() * arriving * (object.phongKD() * std::max(0.0, N.dot(L)));
        const ColourRGB specular = light.colour() * arriving *
            (object.phongKS() * std::pow(std::max(0.0, L.reflectIn(N).dot(toViewer)), object.phongAlpha()));
        // TASK T2.1 begin
        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 start = P + N * kShadowBias;
            const Vector3 way = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection({start, way.normalised()});
            if (!hit || hit->distance > way.magnitude()) ++arrived;
        }
        return ambient + (diffuse + specular) * (static_cast<double>(arrived) / settings().shadowRayCount);
        // TASK T2.1 end
    };
    const auto& lights = scene.pointLights();
    if (lights.empty()) return ambient;
    return std::transform_reduce(lights.begin(), lights.end(), ColourRGB{}, std::plus<>{}, contribution);
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
