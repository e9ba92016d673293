#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <cmath>

namespace raytracer {
namespace {
struct Mean {
    ColourRGB value;
    int count = 0;
    void add(const ColourRGB& c) {
        ++count;
        value += (c - value) / count;
    }
};
}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 V = (O - P).normalised();
    ColourRGB colour = object.colour() * scene.ambientLighting();
    for (const PointLight& light : scene.pointLights()) {
        Mean mean;
        while (mean.count < settings().shadowRayCount) {
            const Vector3 S =
                light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const double d = (S - P).magnitude();
            const Vector3 L = (S - P) / d;
            const auto hit = scene.findClosestIntersection({P + L * kShadowBias, L});
            if (hit && hit->distance < d - kShadowBias) {
                mean.add({});
                continue;
            }
            const ColourRGB I = light.illuminationAt(d);
            mean.add(object.colour() * I * (object.phongKD() * std::max(0.0, N.dot(L))) +
                     light.colour() * I *
                         (object.phongKS() *
                          std::pow(std::max(0.0, L.reflectIn(N).dot(V)), object.phongAlpha())));
        }
        colour += mean.value;
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray pinhole = camera.castRay(x, y);
        const Vector3 focus = pinhole.direction * (settings().dofFocalPlane / pinhole.direction.z);
        Mean mean;
        const double half = settings().dofAmount / 2;
        while (mean.count < settings().dofRayCount) {
            const Vector3 lens{randomBetween(-half, half), randomBetween(-half, half), 0};
            mean.add(trace(scene, {lens, (focus - lens).normalised()}, settings().bounces));
        }
        image.set(x, y, mean.value);
    });
    return image;
}
}  // namespace raytracer
