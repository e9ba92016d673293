// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

struct Onb {
    Vector3 s, t;
    explicit Onb(const Vector3& w) {
        s = Vector3{0.0, 1.0, 0.0}.cross(w).normalised();
        t = w.cross(s);
    }
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
        int blocked = 0;
        for (int k = 0; k != settings().shadowRayCount; ++k) {
            Vector3 offset = Vector3::randomInsideUnitSphere();
            offset *= settings().lightSize;
            const Vector3 origin = P + kShadowBias * N;
            const Vector3 d = light.position() + offset - origin;
            const double reach = d.magnitude();
            if (const auto h = scene.findClosestIntersection({origin, d / reach}); h && h->distance < reach) ++blocked;
        }
        colour += (diffuse + specular) * (1.0 - static_cast<double>(blocked) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray chief = camera.castRay(x, y);
        const Vector3 focus = chief.evaluateAt(settings().dofFocalPlane / chief.direction.z);
        const Onb lensPlane{chief.direction};
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double a = settings().dofAmount * randomBetween(-1.0, 1.0);
            const double b = settings().dofAmount * randomBetween(-1.0, 1.0);
            const Vector3 lens = chief.origin + lensPlane.s * a + lensPlane.t * b;
            sum += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
