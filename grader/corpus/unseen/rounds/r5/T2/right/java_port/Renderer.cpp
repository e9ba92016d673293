// Java, rewritten in C++: DistributedRenderer.java
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace raytracer {

namespace {
#define final const
class ShadowRayTask {
  private:
    final Scene& scene;
    final Vector3 origin;
    int hits = 0;
    int total = 0;

  public:
    ShadowRayTask(final Scene& scene, final Vector3& origin) : scene(scene), origin(origin) {}
    void castTo(final Vector3& target) {
        total++;
        Vector3 direction = target - origin;
        double length = direction.magnitude();
        std::optional<RaycastHit> hit = scene.findClosestIntersection(Ray(origin, direction / length));
        if (hit == std::nullopt) { return; }
        if (hit->distance < length) { hits++; }
    }
    double getVisibility() final { return 1.0 - (double)hits / (double)total; }
};

class ColourAccumulator {
  private:
    std::vector<double> rgb = std::vector<double>(3, 0.0);
    int count = 0;

  public:
    void add(final ColourRGB& c) {
        rgb[0] += c.r;
        rgb[1] += c.g;
        rgb[2] += c.b;
        ++count;
    }
    ColourRGB getMean() final { return ColourRGB(rgb[0] / count, rgb[1] / count, rgb[2] / count); }
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
        auto task = std::make_unique<ShadowRayTask>(scene, P + N * kShadowBias);
        for (int i = 0; i < settings().shadowRayCount; i++) {
            task->castTo(light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize);
        }
        colour += diffuse * task->getVisibility();
        colour += specular * task->getVisibility();
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        Ray ray = camera.castRay(x, y);
        double scale = settings().dofFocalPlane / ray.direction.z;
        Vector3 focalPoint = ray.direction * scale;
        auto accumulator = std::make_unique<ColourAccumulator>();
        for (int i = 0; i < settings().dofRayCount; i++) {
            double lensX = randomBetween(-1, 1) * settings().dofAmount;
            double lensY = randomBetween(-1, 1) * settings().dofAmount;
            Vector3 lens = Vector3(lensX, lensY, 0);
            accumulator->add(trace(scene, Ray(lens, (focalPoint - lens).normalised()), settings().bounces));
        }
        image.set(x, y, accumulator->getMean());
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
