// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

/// Whether a sphere comes so near to the way to the light that it may hide a part of it.
bool mayBeInPenumbra(const Scene& scene, const Vector3& from, const Vector3& light, double size) {
    const Vector3 way = light - from;
    for (const auto& object : scene.objects()) {
        const auto* sphere = dynamic_cast<const Sphere*>(object.get());
        if (sphere == nullptr) continue;
        const double t = std::clamp((sphere->centre() - from).dot(way) / way.dot(way), 0.0, 1.0);
        if ((from + way * t - sphere->centre()).magnitude() < sphere->radius() + size) return true;
    }
    return false;
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
        int rays = settings().shadowRayCount;
        if (mayBeInPenumbra(scene, P, light.position(), settings().lightSize)) rays *= 4;
        const Vector3 start = P + N * kShadowBias;
        double visible = 0.0;
        for (int i = 0; i < rays; ++i) {
            const Vector3 aim = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 way = aim - start;
            const auto hit = scene.findClosestIntersection({start, way.normalised()});
            if (hit && hit->distance < way.magnitude()) continue;
            visible += 1.0;
        }
        visible /= rays;
        colour += (diffuse + specular) * visible;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray ray = camera.castRay(x, y);
        const double f = settings().dofFocalPlane;
        const Vector3 focal = ray.evaluateAt(f / ray.direction.z);

        int rays = settings().dofRayCount;
        if (const auto first = scene.findClosestIntersection(ray)) {
            // Width of the blur seen on the plane z = 1, counted in pixels.
            const double z = first->location.z;
            const double blur = settings().dofAmount * std::abs(1.0 / f - 1.0 / z) * settings().width;
            rays = static_cast<int>(std::lround(rays * std::clamp(blur / 8.0, 1.0, 4.0)));
        }

        ColourRGB sum;
        for (int i = 0; i < rays; ++i) {
            const double u = randomBetween(-1.0, 1.0);
            const double v = randomBetween(-1.0, 1.0);
            const Vector3 from = ray.origin + Vector3{u, v, 0} * settings().dofAmount;
            sum += trace(scene, {from, (focal - from).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / rays);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
