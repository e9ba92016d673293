#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace raytracer {

namespace {

struct Spot {
    double u;
    double v;
};

double apart(const Spot& a, const Spot& b) {
    double du = std::abs(a.u - b.u);
    double dv = std::abs(a.v - b.v);
    du = std::min(du, 1.0 - du);
    dv = std::min(dv, 1.0 - dv);
    return du * du + dv * dv;
}

std::vector<Spot> scatter(int count) {
    std::vector<Spot> spots;
    while (static_cast<int>(spots.size()) < count) {
        Spot best{};
        double farthest = -1.0;
        for (int candidate = 0; candidate < 6; ++candidate) {
            const Spot next{randomBetween(0.0, 1.0), randomBetween(0.0, 1.0)};
            double nearest = 2.0;
            for (const Spot& spot : spots)
                nearest = std::min(nearest, apart(spot, next));
            if (nearest <= farthest) continue;
            farthest = nearest;
            best = next;
        }
        spots.push_back(best);
    }
    return spots;
}

Vector3 inBall() {
    const double z = randomBetween(-1.0, 1.0);
    const double turn = randomBetween(0.0, 2.0 * std::numbers::pi);
    const double r = std::cbrt(randomBetween(0.0, 1.0));
    const double ring = std::sqrt(1.0 - z * z);
    return Vector3{ring * std::cos(turn), ring * std::sin(turn), z} * r;
}

}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 eye = (O - P).normalised();
    ColourRGB out = object.colour() * scene.ambientLighting();
    for (const PointLight& lamp : scene.pointLights()) {
        const Vector3 way = lamp.position() - P;
        const Vector3 L = way.normalised();
        const ColourRGB power = lamp.illuminationAt(way.magnitude());
        ColourRGB direct = object.colour() * power * (object.phongKD() * std::max(0.0, N.dot(L)));
        direct += lamp.colour() * power *
                  (object.phongKS() *
                   std::pow(std::max(0.0, L.reflectIn(N).dot(eye)), object.phongAlpha()));
        int open = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 from = P + N * kShadowBias;
            const Vector3 aim = lamp.position() + inBall() * settings().lightSize;
            const Ray ray{from, (aim - from).normalised()};
            const auto hit = scene.findClosestIntersection(ray);
            if (!hit || hit->distance > (aim - from).magnitude()) ++open;
        }
        out += direct * (static_cast<double>(open) / settings().shadowRayCount);
    }
    return out;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    const double A = settings().dofAmount;
    forEachPixel(image, [&](int x, int y) {
        const Ray through = camera.castRay(x, y);
        const Vector3 sharp = through.direction * (settings().dofFocalPlane / through.direction.z);
        ColourRGB sum;
        for (const Spot& spot : scatter(settings().dofRayCount)) {
            const Vector3 lens{A * (2.0 * spot.u - 1.0), A * (2.0 * spot.v - 1.0), 0.0};
            sum += trace(scene, Ray{lens, (sharp - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
