// The standard library knows distributions; a generator for each thread.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <thread>

namespace raytracer {

namespace {

std::mt19937_64& engine() {
    thread_local std::mt19937_64 generator{std::random_device{}() ^
                                           std::hash<std::thread::id>{}(std::this_thread::get_id())};
    return generator;
}

/// Gaussian direction, cube-root radius.
Vector3 inBall(double radius) {
    std::normal_distribution<double> gauss;
    std::uniform_real_distribution<double> flat{0.0, 1.0};
    auto& e = engine();
    const double x = gauss(e), y = gauss(e), z = gauss(e);
    return Vector3{x, y, z}.normalised() * (radius * std::cbrt(flat(e)));
}

Vector3 inSquare(double half) {
    std::uniform_real_distribution<double> flat{-half, half};
    auto& e = engine();
    const double x = flat(e);
    const double y = flat(e);
    return {x, y, 0.0};
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
        const Vector3 lifted = P + N * kShadowBias;
        int seen = 0, asked = 0;
        while (asked < settings().shadowRayCount) {
            const Vector3 aim = light.position() + inBall(settings().lightSize);
            const Vector3 way = aim - lifted;
            const auto first = scene.findClosestIntersection({lifted, way.normalised()});
            seen += (!first || first->distance > way.magnitude()) ? 1 : 0;
            ++asked;
        }
        colour += (specular + diffuse) * seen / asked;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray chief = camera.castRay(x, y);
        const Vector3 focus = chief.origin + chief.direction * ((settings().dofFocalPlane - chief.origin.z) / chief.direction.z);
        ColourRGB light;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 eye = chief.origin + inSquare(settings().dofAmount);
            light += trace(scene, {eye, (focus - eye).normalised()}, settings().bounces);
        }
        light /= settings().dofRayCount;
        image.set(x, y, light);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
