// Running means (Welford), by recursion; nothing is ever summed.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace raytracer {

namespace {

template <typename T>
class Mean {
public:
    [[nodiscard]] Mean with(const T& sample) const {
        Mean next;
        next.n_ = n_ + 1;
        next.value_ = value_ + (sample - value_) / static_cast<double>(next.n_);
        return next;
    }
    [[nodiscard]] const T& value() const { return value_; }

private:
    int n_ = 0;
    T value_{};
};

template <typename T, typename Draw>
Mean<T> meanOf(int n, const Draw& draw, Mean<T> soFar = {}) {
    if (n == 0) return soFar;
    return meanOf<T>(n - 1, draw, soFar.with(draw()));
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
        const Vector3 origin = P + N * kShadowBias;
        const double visibility = meanOf<double>(settings().shadowRayCount, [&] {
            const Vector3 target = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const auto hit = scene.findClosestIntersection(Ray{origin, (target - origin).normalised()});
            // compare places, not lengths
            return hit && (hit->location - origin).dot(target - origin) < (target - origin).dot(target - origin) ? 0.0 : 1.0;
        }).value();
        colour += (diffuse + specular) * visibility;
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
        image.set(x, y, meanOf<ColourRGB>(settings().dofRayCount, [&] {
            const double lx = randomBetween(-1.0, 1.0);
            const Vector3 lens = Vector3{lx, randomBetween(-1.0, 1.0), 0.0} * settings().dofAmount;
            return trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
        }).value());
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
