// T2.1: every shadow ray is a little light of its own: distance, direction, diffuse and specular are
// computed for the place that the ray goes to. The ones that are blocked give nothing.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>

namespace raytracer {

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 toViewer = (O - P).normalised();
    ColourRGB colour = object.colour() * scene.ambientLighting();

    // TASK T2.1 begin
    for (const PointLight& light : scene.pointLights()) {
        ColourRGB fromThisLight;
        for (int k = 0; k < settings().shadowRayCount; ++k) {
            const Vector3 sample =
                light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();

            // blocked?
            const Vector3 lifted = P + N * kShadowBias;
            const Vector3 path = sample - lifted;
            const auto hit = scene.findClosestIntersection(Ray{lifted, path.normalised()});
            if (hit && hit->distance < path.magnitude()) continue;

            // Phong
            const Vector3 L = (sample - P).normalised();
            const ColourRGB I = light.illuminationAt((sample - P).magnitude());
            const double NdotL = std::max(0.0, N.dot(L));
            const double RdotV = std::max(0.0, L.reflectIn(N).dot(toViewer));
            fromThisLight += object.colour() * I * (object.phongKD() * NdotL);
            fromThisLight += light.colour() * I *
                             (object.phongKS() * std::pow(RdotV, object.phongAlpha()));
        }
        colour += fromThisLight / settings().shadowRayCount;
    }
    // TASK T2.1 end
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        Ray pinhole = camera.castRay(x, y);
        Vector3 focal = pinhole.origin + pinhole.direction * ((settings().dofFocalPlane -
                                                                pinhole.origin.z) /
                                                               pinhole.direction.z);
        double r = 0, g = 0, b = 0;
        for (int k = 0; k < settings().dofRayCount; ++k) {
            double dx = settings().dofAmount * randomBetween(-1, 1);
            double dy = settings().dofAmount * randomBetween(-1, 1);
            Vector3 eye = pinhole.origin + Vector3(dx, dy, 0);
            ColourRGB c = trace(scene, Ray(eye, (focal - eye).normalised()), settings().bounces);
            r += c.r;
            g += c.g;
            b += c.b;
        }
        int n = settings().dofRayCount;
        image.set(x, y, ColourRGB(r / n, g / n, b / n));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
