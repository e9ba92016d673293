// SoftShadowRenderer.java
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace raytracer {

namespace {
#define final const
class LightSampler {
  private:
    final Scene& scene;
    final int samples;
    final double size;

  public:
    LightSampler(final Scene& scene, final RenderSettings& s)
        : scene(scene), samples(s.shadowRayCount), size(s.lightSize) {}
    double visible(final Vector3& from, final PointLight& light) final {
        int unblocked = 0;
        for (int i = 0; i < samples; i++) {
            Vector3 target = light.position() + Vector3::randomInsideUnitSphere() * size;
            std::optional<RaycastHit> hit = scene.findClosestIntersection(Ray(from, (target - from).normalised()));
            if (!hit.has_value() || hit->distance > (target - from).magnitude()) { unblocked++; }
        }
        return unblocked / samples;
    }
};
#undef final
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
        const double visibility = LightSampler(scene, settings()).visible(P + N * kShadowBias, light);
        colour += diffuse * visibility + specular * visibility;
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
