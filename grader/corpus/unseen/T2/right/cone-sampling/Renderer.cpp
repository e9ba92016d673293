// Soft shadows with directions drawn uniformly from the cone that the ball fills as seen from the
// point (PBRT 3, 14.2.2). Each ray ends where it enters the ball... or better in its middle: at a
// random place of the chord, so that the aim point lies inside the light as the handout says.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

struct Basis {
    Vector3 x, y, z;
    explicit Basis(const Vector3& axis) : z(axis) {
        x = (std::abs(z.x) > 0.5 ? Vector3{0, 1, 0} : Vector3{1, 0, 0}).cross(z).normalised();
        y = z.cross(x);
    }
    Vector3 toWorld(double a, double b, double c) const { return x * a + y * b + z * c; }
};

// A random point of the ball as seen from `from`, uniform over the solid angle.
Vector3 aimPoint(const Vector3& from, const Vector3& centre, double radius) {
    const Vector3 way = centre - from;
    const double squared = way.dot(way);
    if (squared <= radius * radius * 1.0001)  // inside the light, or as good as
        return centre + Vector3::randomInsideUnitSphere() * radius;
    const double distance = std::sqrt(squared);
    const double sinMax2 = radius * radius / squared;
    const double cosMax = std::sqrt(std::max(0.0, 1.0 - sinMax2));
    const double cosine = 1.0 - randomBetween(0.0, 1.0) * (1.0 - cosMax);
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    const double angle = randomBetween(0.0, 2.0 * std::numbers::pi);
    const Vector3 d =
        Basis{way / distance}.toWorld(sine * std::cos(angle), sine * std::sin(angle), cosine);
    const double half =
        std::sqrt(std::max(0.0, radius * radius - squared * sine * sine));  // of the chord
    return from + d * (distance * cosine + randomBetween(-half, half));
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
        const Vector3 from = P + N * kShadowBias;
        const int n = settings().shadowRayCount;
        int clear = 0;
        for (int i = 0; i < n; ++i) {
            const Vector3 way = aimPoint(from, light.position(), settings().lightSize) - from;
            const double length = way.magnitude();
            const auto blocker = scene.findClosestIntersection({from, way / length});
            if (!blocker || blocker->distance >= length) ++clear;
        }
        colour += (diffuse + specular) * (static_cast<double>(clear) / n);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray axis = camera.castRay(x, y);
        // similar triangles: scale the direction so that its z is the focal plane's
        const Vector3 focus = axis.direction * (settings().dofFocalPlane / axis.direction.z);
        ColourRGB sum{0.0};
        for (int n = settings().dofRayCount; n > 0; --n) {
            const Vector3 lens = Vector3{randomBetween(-1, 1), randomBetween(-1, 1), 0} *
                                 settings().dofAmount;
            const Vector3 way = focus - lens;
            sum += trace(scene, {lens, way / way.magnitude()}, settings().bounces);
        }
        image.set(x, y, sum * (1.0 / settings().dofRayCount));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
