// PBRT's way to see a spherical light: directions uniform in the cone that it fills.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

struct Frame {
    Vector3 s, t, n;
    explicit Frame(const Vector3& axis) : n(axis) {
        const double sign = std::copysign(1.0, n.z);
        const double a = -1.0 / (sign + n.z), b = n.x * n.y * a;
        s = {1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x};
        t = {b, sign + n.y * n.y * a, -n.y};
    }
};

/// A point of the near side of the ball, uniform in the solid angle seen from `from`.
Vector3 pointOnBall(const Vector3& centre, double radius, const Vector3& from) {
    const Vector3 axis = centre - from;
    const double d2 = axis.dot(axis);
    if (d2 <= radius * radius * 1.0001) return centre + radius * Vector3::randomInsideUnitSphere();
    const double d = std::sqrt(d2);
    const double sin2Max = radius * radius / d2;
    const double cosMax = std::sqrt(1.0 - sin2Max);
    const double cosine = 1.0 - randomBetween(0.0, 1.0) * (1.0 - cosMax);
    const double sine2 = std::max(0.0, 1.0 - cosine * cosine);
    const double phi = randomBetween(0.0, 2.0 * std::numbers::pi);
    const Frame f{axis / d};
    const Vector3 w = (f.s * std::cos(phi) + f.t * std::sin(phi)) * std::sqrt(sine2) + f.n * cosine;
    const double reach = d * cosine - std::sqrt(std::max(0.0, radius * radius - d2 * sine2));
    return from + w * reach;
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

        // TASK T2.1 begin
        const Vector3 start = P + N * kShadowBias;
        int visible = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 aim = pointOnBall(light.position(), settings().lightSize, start);
            const double reach = (aim - start).magnitude();
            const auto hit = scene.findClosestIntersection(Ray{start, (aim - start) / reach});
            if (!hit || hit->distance > reach) ++visible;
        }
        colour += (diffuse + specular) * (static_cast<double>(visible) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
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
