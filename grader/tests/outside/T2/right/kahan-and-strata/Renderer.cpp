#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace raytracer {

namespace {
struct Kahan {
    long double sum = 0, rest = 0;
    void add(double v) { const long double y = v - rest, t = sum + y; rest = (t - sum) - y; sum = t; }
};
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

        if (facing <= 0 && mirrored <= 0) continue;
        int blocked = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 aim = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const Vector3 way = aim - P;
            const auto hit = scene.findClosestIntersection(Ray{P + 1e-5 * N, way.normalised()});
            if (hit && (hit->location - P).magnitude() < way.magnitude()) ++blocked;
        }
        colour += (1 - blocked / double(settings().shadowRayCount)) * (diffuse + specular);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray middle = camera.castRay(x, y);
        const Vector3 focus = middle.evaluateAt((settings().dofFocalPlane - middle.origin.z) / middle.direction.z);
        const int n = settings().dofRayCount, side = std::max(1, static_cast<int>(std::sqrt(n)));
        Kahan r, g, b;
        for (int i = 0; i < n; ++i) {
            double u = randomBetween(0, 1), v = randomBetween(0, 1);
            if (i < side * side) { u = (i % side + u) / side; v = (i / side + v) / side; }
            const Vector3 eye{(2 * u - 1) * settings().dofAmount, (2 * v - 1) * settings().dofAmount, 0};
            const ColourRGB c = trace(scene, Ray{eye, (focus - eye).normalised()}, settings().bounces);
            r.add(c.r); g.add(c.g); b.add(c.b);
        }
        image.set(x, y, {double(r.sum / n), double(g.sum / n), double(b.sum / n)});
    });
    return image;
}

}  // namespace raytracer
