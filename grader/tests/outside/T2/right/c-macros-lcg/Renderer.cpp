#include <raytracer/render/Renderer.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#define RND (seed = seed * 6364136223846793005ULL + 1442695040888963407ULL, (double)(seed >> 11) / 9007199254740992.0)
#define SGN (2 * RND - 1)
#define FOR(i, n) for (int i = 0; i < (n); ++i)
namespace raytracer {
static thread_local uint64_t seed = 12345;

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P, const Vector3& N, const Vector3& O) const {
    ColourRGB out = object.colour() * scene.ambientLighting();
    const int lights = (int)scene.pointLights().size();
    FOR(l, lights) {
        const PointLight* li = &scene.pointLights()[(size_t)l];
        Vector3 L = li->position() - P, a;
        double d = L.magnitude(), diff, spec;
        int ok = 0;
        L /= d;
        diff = N.dot(L);
        if (diff <= 0) diff = 0;
        spec = L.reflectIn(N).dot((O - P).normalised());
        spec = spec <= 0 ? 0 : pow(spec, object.phongAlpha());
        FOR(i, settings().shadowRayCount) {
        again:
            a = Vector3(SGN, SGN, SGN);
            if (a.dot(a) > 1) goto again;
            a = li->position() + a * settings().lightSize - P;
            Ray ray(P + a.normalised() * 1e-4, a.normalised());
            auto h = scene.findClosestIntersection(ray);
            if (!h || h->distance >= d) ok++;
        }
        ColourRGB I = li->illuminationAt(d) * ((double)ok / settings().shadowRayCount);
        out += object.colour() * I * (diff * object.phongKD()) + li->colour() * I * (spec * object.phongKS());
    }
    return out;
}

Image Renderer::render(const Scene& scene) const {
    Camera cam(settings());
    Image img(settings());
    FOR(y, img.height()) FOR(x, img.width()) {
        ColourRGB c;
        FOR(i, settings().dofRayCount) {
            Ray r = cam.castRay(x, y);
            double t = settings().dofFocalPlane / r.direction.z;
            r.origin.x += SGN * settings().dofAmount;
            r.origin.y += SGN * settings().dofAmount;
            r.direction = (cam.castRay(x, y).direction * t - r.origin).normalised();
            c += trace(scene, r, settings().bounces) / (double)settings().dofRayCount;
        }
        img.set(x, y, c);
    }
    fprintf(stderr, "done\n");
    return img;
}

}  // namespace raytracer
