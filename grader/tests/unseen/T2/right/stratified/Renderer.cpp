// Jittered samples: the lens is cut into columns x rows cells of the same area, the light into
// shells x sectors; whatever does not fit into the grid is drawn from the whole.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace raytracer {
namespace {

struct UnitSquare {
    double s, t;
};

// count points of [0,1)^2
std::vector<UnitSquare> jittered(int count) {
    const int columns = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(count))));
    const int rows = count / columns;
    std::vector<UnitSquare> points;
    points.reserve(static_cast<std::size_t>(count));
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c)
            points.push_back({(c + randomBetween(0, 1)) / columns, (r + randomBetween(0, 1)) / rows});
    while (static_cast<int>(points.size()) < count)
        points.push_back({randomBetween(0, 1), randomBetween(0, 1)});
    return points;
}

// Stratified in direction, free in radius: uniform in the ball of radius 1.
Vector3 inBall(const UnitSquare& p) {
    const double cosine = 1.0 - 2.0 * p.s;
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    const double angle = 2.0 * std::numbers::pi * p.t;
    const double r = std::cbrt(randomBetween(0.0, 1.0));
    return Vector3{sine * std::cos(angle), sine * std::sin(angle), cosine} * r;
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
        int open = 0;
        for (const UnitSquare& p : jittered(settings().shadowRayCount)) {
            const Vector3 way = light.position() + inBall(p) * settings().lightSize - start;
            const double length = way.magnitude();
            const auto hit = scene.findClosestIntersection({start, way / length});
            open += !hit || hit->distance > length;
        }
        colour += (diffuse + specular) * open / settings().shadowRayCount;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    const double A = settings().dofAmount;
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 focal = d * (settings().dofFocalPlane / d.z);
        ColourRGB sum;
        for (const UnitSquare& p : jittered(settings().dofRayCount)) {
            const Vector3 eye{A * (2 * p.s - 1), A * (2 * p.t - 1), 0};
            sum += trace(scene, {eye, (focal - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
