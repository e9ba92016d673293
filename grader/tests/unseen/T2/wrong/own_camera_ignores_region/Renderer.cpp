// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

class ThinLensCamera {
public:
    ThinLensCamera(const RenderSettings& s, const Image& film)
        : halfWidth_(film.width() / 2.0), halfHeight_(film.height() / 2.0),
          scale_(std::tan(std::numbers::pi / 8.0) / halfWidth_), focal_(s.dofFocalPlane), aperture_(s.dofAmount) {}

    [[nodiscard]] Ray sample(int x, int y) const {
        const Vector3 focus = Vector3{(x + 0.5 - halfWidth_) * scale_, (halfHeight_ - y - 0.5) * scale_, 1.0} * focal_;
        const Vector3 lens{randomBetween(-aperture_, aperture_), randomBetween(-aperture_, aperture_), 0.0};
        return {lens, (focus - lens).normalised()};
    }

private:
    double halfWidth_, halfHeight_, scale_, focal_, aperture_;
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
    Image image{settings()};
    const ThinLensCamera camera{settings(), image};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i)
            sum += trace(scene, camera.sample(x, y), settings().bounces);
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
