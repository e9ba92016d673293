// Low-discrepancy light points.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace raytracer {

namespace {
template <unsigned Base>
double radicalInverse(std::uint32_t n) {
    double f = 1.0, r = 0.0;
    for (; n; n /= Base) r += (f /= Base) * (n % Base);
    return r;
}
/// Halton in [-1, 1)^3, shifted at random, rejected outside the ball.
class BallSequence {
public:
    BallSequence() : shift_(randomBetween(0, 1)), n_(1) {}
    Vector3 next() {
        for (;;) {
            const std::uint32_t n = n_++;
            const Vector3 p{coordinate<2>(n), coordinate<2>(n), coordinate<2>(n)};
            if (p.dot(p) < 1.0) return p;
        }
    }

private:
    template <unsigned B>
    double coordinate(std::uint32_t n) const { return 2.0 * std::fmod(radicalInverse<B>(n) + shift_, 1.0) - 1.0; }
    double shift_;
    std::uint32_t n_;
};
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
        BallSequence points;
        const Vector3 o = P + N * kShadowBias;
        int reached = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 w = light.position() + points.next() * settings().lightSize - o;
            const auto hit = scene.findClosestIntersection(Ray{o, w.normalised()});
            if (!hit || hit->distance > w.magnitude()) ++reached;
        }
        colour += (diffuse + specular) * (static_cast<double>(reached) / settings().shadowRayCount);
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
