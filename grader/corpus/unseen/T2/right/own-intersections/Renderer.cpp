// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace raytracer {
namespace {

/// True if a surface crosses the open segment from a to b.
bool anythingBetween(const Scene& scene, const Vector3& a, const Vector3& b) {
    const Vector3 d = b - a;
    for (const std::unique_ptr<SceneObject>& object : scene.objects()) {
        if (const auto* sphere = dynamic_cast<const Sphere*>(object.get())) {
            const Vector3 m = a - sphere->centre();
            const double qa = d.dot(d);
            const double qb = m.dot(d);
            const double qc = m.dot(m) - sphere->radius() * sphere->radius();
            const double disc = qb * qb - qa * qc;
            if (disc < 0.0) continue;
            const double root = std::sqrt(disc);
            const double t1 = (-qb - root) / qa;
            const double t2 = (-qb + root) / qa;
            if ((t1 > 0.0 && t1 < 1.0) || (t2 > 0.0 && t2 < 1.0)) return true;
        } else if (const auto* plane = dynamic_cast<const Plane*>(object.get())) {
            const double before = (a - plane->point()).dot(plane->normal());
            const double after = (b - plane->point()).dot(plane->normal());
            if ((before > 0.0) != (after > 0.0)) return true;
        } else {
            const auto hit = object->intersectionWith(Ray{a, d});
            if (hit && hit->distance < 1.0) return true;
        }
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
        const Vector3 start = P + N * kShadowBias;
        int lit = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 aim = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            if (!anythingBetween(scene, start, aim)) ++lit;
        }
        colour += (diffuse + specular) * (lit / static_cast<double>(settings().shadowRayCount));
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
        const Plane inFocus{{0.0, 0.0, settings().dofFocalPlane}, {0.0, 0.0, -1.0}, Material{}};
        const Vector3 focal = inFocus.intersectionWith(ray).value().location;
        ColourRGB colour;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double dx = settings().dofAmount * randomBetween(-1.0, 1.0);
            const double dy = settings().dofAmount * randomBetween(-1.0, 1.0);
            const Vector3 lens = ray.origin + Vector3{dx, dy, 0.0};
            colour += trace(scene, Ray{lens, (focal - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, colour / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
