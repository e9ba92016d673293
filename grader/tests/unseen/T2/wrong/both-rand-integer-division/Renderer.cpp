// C's rand() in both tasks
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace raytracer {

/** random number in [-1, 1] */
static double random11() { return 2.0 * (rand() / RAND_MAX) - 1.0; }

static Vector3 randomInBall() {
    Vector3 v(random11(), random11(), random11());
    // inside the sphere
    if (v.magnitude() > 1) v = v.normalised();
    return v;
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
        int lit = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            Vector3 start = P + N * kShadowBias;
            Vector3 end = light.position() + randomInBall() * settings().lightSize;
            auto hit = scene.findClosestIntersection(Ray(start, (end - start).normalised()));
            if (!hit || hit->distance > (end - start).magnitude()) lit++;
        }
        colour += (diffuse + specular) * (double(lit) / settings().shadowRayCount);
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
        Vector3 focal = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; i++) {
            Vector3 origin(settings().dofAmount * random11(), settings().dofAmount * random11(), 0);
            sum += trace(scene, Ray(origin, (focal - origin).normalised()), settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
