// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <valarray>

namespace raytracer {

namespace {
using Numbers = std::valarray<double>;

Numbers randoms(std::size_t n) {
    Numbers a(n);
    for (double& value : a) value = randomBetween(0, 1);
    return a;
}

std::tuple<Numbers, Numbers, Numbers> ball(std::size_t n) {
    const Numbers height = 2.0 * randoms(n) - 1.0;
    const Numbers turn = 2.0 * std::numbers::pi * randoms(n);
    const Numbers radius = std::pow(randoms(n), 1.0 / 3.0);
    const Numbers ring = std::sqrt(1.0 - height * height);
    return {radius * ring * std::cos(turn), radius * ring * std::sin(turn), radius * height};
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
        const std::size_t n = settings().shadowRayCount;
        auto [bx, by, bz] = ball(n);
        bx = bx * settings().lightSize + (light.position().x - P.x);
        by = by * settings().lightSize + (light.position().y - P.y);
        bz = bz * settings().lightSize + (light.position().z - P.z);
        const Numbers length = std::sqrt(bx * bx + by * by + bz * bz);
        bx /= length, by /= length, bz /= length;
        Numbers free(1.0, n);
        for (std::size_t i = 0; i < n; ++i)
            if (auto hit = scene.findClosestIntersection({P + N * kShadowBias, {bx[i], by[i], bz[i]}}))
                free[i] = hit->distance > length[i];
        colour += (diffuse + specular) * (free.sum() / double(n));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray pin = camera.castRay(x, y);
        const Vector3 focus = pin.evaluateAt(settings().dofFocalPlane / pin.direction.z);
        const std::size_t n = settings().dofRayCount;
        const Numbers lx = settings().dofAmount * (2.0 * randoms(n) - 1.0);
        const Numbers ly = settings().dofAmount * (2.0 * randoms(n) - 1.0);
        const Numbers dx = focus.x - lx, dy = focus.y - ly;
        const Numbers norm = std::sqrt(dx * dx + dy * dy + focus.z * focus.z);
        Numbers red(n), green(n), blue(n);
        for (std::size_t i = 0; i < n; ++i) {
            const Ray ray{{lx[i], ly[i], 0}, {dx[i] / norm[i], dy[i] / norm[i], focus.z / norm[i]}};
            const ColourRGB c = trace(scene, ray, settings().bounces);
            red[i] = c.r, green[i] = c.g, blue[i] = c.b;
        }
        image.set(x, y, ColourRGB{red.sum(), green.sum(), blue.sum()} / double(n));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
