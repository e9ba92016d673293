#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace raytracer {

static std::vector<Vector3> darts(int n, double half) {
    std::vector<Vector3> v;
    double gap = 1.3 * half / std::sqrt(n);
    while (static_cast<int>(v.size()) < n) {
        bool placed = false;
        for (int t = 0; t < 40 && !placed; ++t) {
            const Vector3 p{randomBetween(-half, half), randomBetween(-half, half), 0};
            placed = std::none_of(v.begin(), v.end(), [&](const Vector3& q) { return (p - q).magnitude() < gap; });
            if (placed) v.push_back(p);
        }
        if (!placed) gap *= 0.8;
    }
    return v;
}

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

        const int n = settings().shadowRayCount;
        Vector3 a = Vector3::randomInsideUnitSphere().normalised();
        Vector3 b = a.cross(Vector3::randomInsideUnitSphere()).normalised();
        const Vector3 c = a.cross(b);
        int arrived = 0;
        for (int i = 0; i < n; ++i) {
            const double z = 1 - (2 * i + 1.0) / n, q = std::sqrt(1 - z * z), t = 2.399963229728653 * i;
            const Vector3 aim = light.position() + (a * (q * std::cos(t)) + b * (q * std::sin(t)) + c * z) * settings().lightSize;
            const Vector3 way = aim - (P + N * kShadowBias);
            const auto hit = scene.findClosestIntersection(Ray{P + N * kShadowBias, way.normalised()});
            arrived += !(hit && hit->distance < way.magnitude());
        }
        colour += (diffuse + specular) * arrived / n;
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray middle = camera.castRay(x, y);
        const Vector3 focus = middle.evaluateAt(settings().dofFocalPlane / middle.direction.z);
        ColourRGB sum;
        const auto points = darts(settings().dofRayCount, settings().dofAmount);
        for (const Vector3& eye : points) sum += trace(scene, Ray{eye, (focus - eye).normalised()}, settings().bounces);
        image.set(x, y, sum * (1.0 / static_cast<double>(points.size())));
    });
    return image;
}

}  // namespace raytracer
