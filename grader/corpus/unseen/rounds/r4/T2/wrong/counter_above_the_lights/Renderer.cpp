#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <cmath>

namespace raytracer {

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    // everything that I need
    Vector3 V = (O - P).normalised();
    Vector3 start = P + N * kShadowBias;
    ColourRGB colour = object.colour() * scene.ambientLighting();
    int rays = 0;
    int reached = 0;

    for (const PointLight& light : scene.pointLights()) {
        Vector3 L = light.position() - P;
        double distance = L.magnitude();
        L = L.normalised();
        ColourRGB I = light.illuminationAt(distance);
        double a = N.dot(L);
        if (a < 0.0) a = 0.0;
        double b = L.reflectIn(N).dot(V);
        if (b < 0.0) b = 0.0;
        ColourRGB diffuse = object.colour() * I * object.phongKD() * a;
        ColourRGB specular = light.colour() * I * object.phongKS() * std::pow(b, object.phongAlpha());

        for (int i = 0; i < settings().shadowRayCount; i++) {
            Vector3 q = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            double d = (q - start).magnitude();
            auto hit = scene.findClosestIntersection(Ray(start, (q - start) / d));
            rays++;
            if (!hit || hit->distance > d) reached++;
        }
        colour += (diffuse + specular) * (1.0 * reached / rays);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    Camera camera(settings());
    Image image(settings());
    forEachPixel(image, [&](int x, int y) {
        Ray ray = camera.castRay(x, y);
        Vector3 focus = ray.direction * (settings().dofFocalPlane / ray.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; i++) {
            double rx = randomBetween(-1, 1) * settings().dofAmount;
            double ry = randomBetween(-1, 1) * settings().dofAmount;
            Vector3 o(rx, ry, 0);
            sum += trace(scene, Ray(o, (focus - o).normalised()), settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
