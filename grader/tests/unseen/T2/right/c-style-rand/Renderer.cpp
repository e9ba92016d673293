#include <math.h>
#include <raytracer/render/Renderer.h>
#include <stdlib.h>

#define RND (2.0 * rand() / RAND_MAX - 1.0)

namespace raytracer {
ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    double r, g, b;
    size_t l;
    int i, n = settings().shadowRayCount;
    r = object.colour().r * scene.ambientLighting().r;
    g = object.colour().g * scene.ambientLighting().g;
    b = object.colour().b * scene.ambientLighting().b;
    for (l = 0; l < scene.pointLights().size(); l++) {
        const PointLight& light = scene.pointLights()[l];
        double dx = light.position().x - P.x, dy = light.position().y - P.y,
               dz = light.position().z - P.z;
        double d = sqrt(dx * dx + dy * dy + dz * dz);
        int seen = n;
        for (i = 0; i < n; i++) {
            double x, y, z;
            do {
                x = RND;
                y = RND;
                z = RND;
            } while (x * x + y * y + z * z > 1);
            Vector3 s(P.x + 1e-4 * N.x, P.y + 1e-4 * N.y, P.z + 1e-4 * N.z);
            Vector3 t(light.position().x + x * settings().lightSize - s.x,
                      light.position().y + y * settings().lightSize - s.y,
                      light.position().z + z * settings().lightSize - s.z);
            double len = t.magnitude();
            std::optional<RaycastHit> h = scene.findClosestIntersection(Ray{s, t.normalised()});
            if (h && h->distance <= len) seen--;
        }
        Vector3 L(dx / d, dy / d, dz / d);
        double nl = N.dot(L);
        if (nl < 0) nl = 0;
        double rv = L.reflectIn(N).dot((O - P).normalised());
        if (rv < 0) rv = 0;
        ColourRGB I = light.illuminationAt(d);
        double kd = object.phongKD() * nl * seen / n,
               ks = object.phongKS() * pow(rv, object.phongAlpha()) * seen / n;
        r += kd * object.colour().r * I.r + ks * light.colour().r * I.r;
        g += kd * object.colour().g * I.g + ks * light.colour().g * I.g;
        b += kd * object.colour().b * I.b + ks * light.colour().b * I.b;
    }
    return ColourRGB(r, g, b);
}

Image Renderer::render(const Scene& scene) const {
    Camera camera(settings());
    Image image(settings());
    int x, y, i;
    srand((unsigned)settings().seed);
    for (y = 0; y < image.height(); y++)
        for (x = 0; x < image.width(); x++) {
            Ray ray = camera.castRay(x, y);
            double fx = ray.direction.x / ray.direction.z * settings().dofFocalPlane;
            double fy = ray.direction.y / ray.direction.z * settings().dofFocalPlane;
            double r = 0, g = 0, b = 0;
            for (i = 0; i < settings().dofRayCount; i++) {
                double lx = RND * settings().dofAmount, ly = RND * settings().dofAmount;
                Vector3 dir(fx - lx, fy - ly, settings().dofFocalPlane);
                ColourRGB c =
                    trace(scene, Ray{Vector3(lx, ly, 0), dir.normalised()}, settings().bounces);
                r += c.r;
                g += c.g;
                b += c.b;
            }
            image.set(x, y, ColourRGB(r / i, g / i, b / i));
        }
    return image;
}
}  // namespace raytracer
