// T2.1 + T2.2. Uses <random> because we had it in the C++ lectures. Each thread has its own engine.
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace raytracer {

static double random01() {
    thread_local std::mt19937 engine{std::random_device{}()};
    thread_local std::uniform_real_distribution<double> distribution{0.0, 1.0};
    return distribution(engine);
}

// random point with x^2 + y^2 + z^2 <= 1: throw away those in the corners of the cube
static Vector3 randomInBall() {
    Vector3 p;
    do {
        p.x = random01() * 2 - 1;
        p.y = random01() * 2 - 1;
        p.z = random01() * 2 - 1;
    } while (p.dot(p) > 1.0);
    return p;
}

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
        double lit = 0.0;
        int raysLeft = settings().shadowRayCount;
        while (raysLeft > 0) {
            raysLeft--;
            Vector3 shadowOrigin = P + N * kShadowBias;
            Vector3 pointOnLight = light.position() + randomInBall() * settings().lightSize;
            Vector3 shadowDirection = (pointOnLight - shadowOrigin).normalised();
            double lightDistance = (pointOnLight - shadowOrigin).magnitude();
            std::optional<RaycastHit> hit =
                scene.findClosestIntersection(Ray{shadowOrigin, shadowDirection});
            bool inShadow = hit.has_value() && hit.value().distance < lightDistance;
            if (!inShadow) lit += 1.0;
        }
        double visibility = lit / settings().shadowRayCount;
        colour = colour + diffuse * visibility + specular * visibility;
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
        // z = 0 + t * direction.z  =>  t = focal / direction.z
        double t = settings().dofFocalPlane / ray.direction.z;
        Vector3 focalPoint = ray.evaluateAt(t);
        ColourRGB total;
        for (int sample = 1; sample <= settings().dofRayCount; sample++) {
            Vector3 origin;
            origin.x = settings().dofAmount * (random01() * 2 - 1);
            origin.y = settings().dofAmount * (random01() * 2 - 1);
            total += trace(scene, Ray{origin, (focalPoint - origin).normalised()},
                           settings().bounces);
        }
        total /= settings().dofRayCount;
        image.set(x, y, total);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
