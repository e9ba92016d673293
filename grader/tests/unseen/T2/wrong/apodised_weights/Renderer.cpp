// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

struct Weighted {
    ColourRGB sum;
    double weight = 0.0;
    void add(const ColourRGB& c, double w) {
        sum += c * w;
        weight += w;
    }
    [[nodiscard]] ColourRGB mean() const { return sum / weight; }
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
        int arrived = 0;
        const Vector3 start = P + N * kShadowBias;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 aim = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Ray ray{start, (aim - start).normalised()};
            const auto hit = scene.findClosestIntersection(ray);
            if (!hit || hit->distance >= (aim - start).magnitude()) arrived++;
        }
        const double share = arrived / static_cast<double>(settings().shadowRayCount);
        colour += share * (diffuse + specular);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray pinhole = camera.castRay(x, y);
        const Vector3 focus = pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
        Weighted pixel;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double u = randomBetween(-1.0, 1.0);
            const double v = randomBetween(-1.0, 1.0);
            const Vector3 lens = Vector3{u, v, 0.0} * settings().dofAmount;
            // Gaussian filter: creamier bokeh
            pixel.add(trace(scene, {lens, (focus - lens).normalised()}, settings().bounces), std::exp(-4.0 * (u * u + v * v)));
        }
        image.set(x, y, pixel.mean());
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
