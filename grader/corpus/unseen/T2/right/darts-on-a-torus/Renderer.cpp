// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace raytracer {

// n points of the unit square, none near another if that can be helped
static std::vector<std::pair<double, double>> darts(int n) {
    auto gap = [](double a, double b) {
        const double d = std::abs(a - b);
        return std::min(d, 1 - d);
    };
    std::vector<std::pair<double, double>> board;
    double radius = 0.7 / std::sqrt(double(n));
    int misses = 0;
    while (int(board.size()) < n) {
        const double a = randomBetween(0, 1), b = randomBetween(0, 1);
        bool ok = true;
        for (auto& [p, q] : board)
            if (std::hypot(gap(a, p), gap(b, q)) < radius) ok = false;
        if (ok) board.emplace_back(a, b), misses = 0;
        else if (++misses > 30) radius *= 0.9, misses = 0;
    }
    return board;
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

        // TASK T2.1 begin
        double arriveShare = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            double ox, oy, oz;
            do {
                ox = randomBetween(-1, 1); oy = randomBetween(-1, 1); oz = randomBetween(-1, 1);
            } while (ox * ox + oy * oy + oz * oz > 1);
            Vector3 target = light.position();
            target.x += ox * settings().lightSize;
            target.y += oy * settings().lightSize;
            target.z += oz * settings().lightSize;
            Vector3 d = target - P;
            auto h = scene.findClosestIntersection(Ray(P + N * kShadowBias, d.normalised()));
            if (!h || h->distance > d.magnitude()) arriveShare += 1;
        }
        arriveShare /= settings().shadowRayCount;
        colour += arriveShare * (diffuse + specular);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray r = camera.castRay(x, y);
        const double k = settings().dofFocalPlane / r.direction.z;
        const Vector3 f{k * r.direction.x, k * r.direction.y, k * r.direction.z};
        ColourRGB sum;
        for (auto [a, b] : darts(settings().dofRayCount)) {
            Vector3 eye{(2 * a - 1) * settings().dofAmount, (2 * b - 1) * settings().dofAmount, 0};
            sum += trace(scene, Ray(eye, (f - eye).normalised()), settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
