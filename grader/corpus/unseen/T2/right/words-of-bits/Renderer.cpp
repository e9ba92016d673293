// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <array>
#include <bit>
#include <cstdint>

namespace raytracer {

namespace {
bool reaches(const Scene& scene, const Vector3& from, const Vector3& centre, double radius) {
    const Vector3 span = centre + Vector3::randomInsideUnitSphere() * radius - from;
    const auto wall = scene.findClosestIntersection(Ray{from, span.normalised()});
    return !wall || wall->distance * wall->distance > span.dot(span);
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
        std::array<std::uint64_t, 64> words{};
        const unsigned n = static_cast<unsigned>(settings().shadowRayCount);
        for (unsigned i = 0; i < n; ++i)
            words[i / 64 % 64] |= 0U;  // touched before use
        unsigned long total = 0;
        for (unsigned first = 0; first < n; first += 64) {
            std::uint64_t word = 0;
            for (unsigned i = first; i < std::min(n, first + 64); ++i)
                word |= std::uint64_t{reaches(scene, P + N * kShadowBias, light.position(), settings().lightSize)} << (i - first);
            total += static_cast<unsigned long>(std::popcount(word));
        }
        colour += (diffuse + specular) * (static_cast<double>(total) / n);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Plane sharp{{0, 0, settings().dofFocalPlane}, {0, 0, -1}, Material{}};
        const Vector3 there = sharp.intersectionWith(camera.castRay(x, y)).value().location;
        const double half = settings().dofAmount;
        ColourRGB light{};
        for (int left = settings().dofRayCount; left-- > 0;) {
            const Vector3 here{randomBetween(-half, half), randomBetween(-half, half), 0};
            light += trace(scene, Ray{here, (there - here).normalised()}, settings().bounces);
        }
        image.set(x, y, light /= settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
