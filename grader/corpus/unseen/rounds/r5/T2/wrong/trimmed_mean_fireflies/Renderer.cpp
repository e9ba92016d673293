// Robust statistics against fireflies: interquartile mean.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace raytracer {

namespace {
double luminance(const ColourRGB& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

/// Mean of the middle half, by luminance.
ColourRGB robustMean(std::vector<ColourRGB> samples) {
    std::sort(samples.begin(), samples.end(),
              [](const ColourRGB& a, const ColourRGB& b) { return luminance(a) < luminance(b); });
    const std::size_t cut = samples.size() / 4;
    ColourRGB sum;
    for (std::size_t i = cut; i < samples.size() - cut; ++i) sum += samples[i];
    return sum / static_cast<double>(samples.size() - 2 * cut);
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
        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            const Vector3 aim = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const Vector3 from = P + kShadowBias * N;
            const auto hit = scene.findClosestIntersection(Ray(from, (aim - from).normalised()));
            if (!hit.has_value() || hit->distance >= (aim - from).magnitude()) arrived++;
        }
        colour += (diffuse + specular) * (double(arrived) / double(settings().shadowRayCount));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray p = camera.castRay(x, y);
        const Vector3 focus = p.evaluateAt(settings().dofFocalPlane / p.direction.z);
        std::vector<ColourRGB> samples(static_cast<std::size_t>(settings().dofRayCount));
        for (ColourRGB& sample : samples) {
            const double lx = randomBetween(-1, 1), ly = randomBetween(-1, 1);
            const Vector3 lens{settings().dofAmount * lx, settings().dofAmount * ly, 0};
            sample = trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, robustMean(std::move(samples)));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
