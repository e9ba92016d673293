#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace raytracer {

namespace {
struct Hit { double t = 1e300; const SceneObject* o = nullptr; Vector3 p; };
bool meets(const SceneObject& o, const Vector3& a, const Vector3& d, double& t) {
    if (const auto* s = dynamic_cast<const Sphere*>(&o)) {
        const Vector3 m = a - s->centre();
        const double b = m.dot(d), c = m.dot(m) - s->radius() * s->radius(), q = b * b - c;
        if (q < 0) return false;
        t = -b - std::sqrt(q);
        if (t <= 0) t = -b + std::sqrt(q);
        return t > 0;
    }
    if (const auto* p = dynamic_cast<const Plane*>(&o)) {
        const double k = p->normal().dot(d);
        if (k == 0) return false;
        t = (p->point() - a).dot(p->normal()) / k;
        return t > 0;
    }
    return false;
}
bool free(const Scene& scene, const Vector3& a, const Vector3& b) {
    const Vector3 d = (b - a).normalised();
    for (const auto& o : scene.objects()) {
        double t;
        if (meets(*o, a, d, t) && t < (b - a).magnitude()) return false;
    }
    return true;
}
thread_local std::mt19937 engine(std::random_device{}());
double uni(double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); }
Vector3 ball() { Vector3 v; do v = {uni(-1, 1), uni(-1, 1), uni(-1, 1)}; while (v.dot(v) > 1); return v; }
}

static ColourRGB own(const Renderer& r, const Scene& scene, const Vector3& a, const Vector3& d, int left) {
    double best = 1e300, t;
    const SceneObject* o = nullptr;
    for (const auto& c : scene.objects())
        if (meets(*c, a, d, t) && t < best) { best = t; o = c.get(); }
    if (!o) return ColourRGB(0.001);
    const Vector3 p = a + d * best, n = o->getNormalAt(p);
    const ColourRGB direct = r.illuminate(scene, *o, p, n, a);
    if (left == 0 || o->reflectivity() == 0) return direct;
    return direct * (1 - o->reflectivity()) + own(r, scene, p + n * 1e-4, (-d).reflectIn(n).normalised(), left - 1) * o->reflectivity();
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

        int arrived = 0;
        const Vector3 start = P + N * kShadowBias;
        for (int i = 0; i < settings().shadowRayCount; ++i)
            if (free(scene, start, light.position() + ball() * settings().lightSize)) ++arrived;
        colour += (diffuse + specular) * (static_cast<double>(arrived) / settings().shadowRayCount);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray middle = camera.castRay(x, y);
        const Vector3 focus = middle.direction * (settings().dofFocalPlane / middle.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 eye{settings().dofAmount * uni(-0.75, 1.25), settings().dofAmount * uni(-1, 1), 0};
            sum += own(*this, scene, eye, (focus - eye).normalised(), settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
