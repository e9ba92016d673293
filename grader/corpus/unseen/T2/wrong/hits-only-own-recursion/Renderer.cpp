#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <cmath>
#include <numbers>
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
        const ColourRGB diffuse =
            object.colour() * arriving * (object.phongKD() * std::max(0.0, N.dot(toLight)));
        const ColourRGB specular =
            light.colour() * arriving *
            (object.phongKS() *
             std::pow(std::max(0.0, toLight.reflectIn(N).dot(toViewer)), object.phongAlpha()));
        const int n = settings().shadowRayCount;
        const Vector3 start = P + N * kShadowBias;

        int reached = 0;
        for (int i = 0; i < n; ++i) {
            const Vector3 target =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 way = target - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
            if (!hit || hit->distance > way.magnitude()) ++reached;
        }

        colour += (diffuse + specular) * (static_cast<double>(reached) / n);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray pinhole = camera.castRay(x, y);
        const Vector3 focus = pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
        ColourRGB sum;
        int hits = 0;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double a = settings().dofAmount;
            const Vector3 lens{randomBetween(-a, a), randomBetween(-a, a), 0};
            const auto hit = scene.findClosestIntersection(Ray{lens, (focus - lens).normalised()});
            if (!hit) continue;
            ++hits;
            ColourRGB c = illuminate(scene, *hit->object, hit->location, hit->normal, lens);
            const double rho = hit->object->reflectivity();
            if (rho > 0 && settings().bounces > 0)
                c = c * (1 - rho) + trace(scene,
                                          Ray{hit->location + hit->normal * kShadowBias,
                                              (lens - focus).normalised().reflectIn(hit->normal)},
                                          settings().bounces - 1) *
                                        rho;
            sum += c;
        }
        image.set(x, y, hits ? sum / hits : kBackgroundColour);
    });
    return image;
}

}  // namespace raytracer
