#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace raytracer {


namespace {
bool blocked(const Scene& scene, const Vector3& from, const Vector3& to) {
    const Vector3 d = to - from;
    for (const auto& thing : scene.objects()) {
        if (const auto* ball = dynamic_cast<const Sphere*>(thing.get())) {
            const Vector3 m = from - ball->centre();
            const double a = d.dot(d), b = m.dot(d), c = m.dot(m) - ball->radius() * ball->radius();
            const double q = b * b - a * c;
            if (q < 0) continue;
            const double t0 = (-b - std::sqrt(q)) / a, t1 = (-b + std::sqrt(q)) / a;
            if ((t0 > 0 && t0 < 1) || (t1 > 0 && t1 < 1)) return true;
        } else if (const auto* flat = dynamic_cast<const Plane*>(thing.get())) {
            const double t = (flat->point() - from).dot(flat->normal()) / d.dot(flat->normal());
            if (t > 0 && t < 1) return true;
        }
    }
    return false;
}
}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    ColourRGB total = object.colour() * scene.ambientLighting();
    for (const auto& light : scene.pointLights()) {
        const Vector3 d = light.position() - P;
        const double far = d.magnitude();
        const Vector3 L = d / far;
        int clear = 0;
        for (int k = 0; k < settings().shadowRayCount; k++) {
            const Vector3 goal = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
            const Vector3 from = P + kShadowBias * N;
            if (!blocked(scene, from, goal)) clear++;
        }
        const double share = clear / static_cast<double>(settings().shadowRayCount);
        const ColourRGB I = light.illuminationAt(far);
        const double cosine = std::max(N.dot(L), 0.0);
        const double shine = std::pow(std::max(L.reflectIn(N).dot((O - P).normalised()), 0.0), object.phongAlpha());
        total += object.colour() * I * (object.phongKD() * cosine * share);
        total += light.colour() * I * (object.phongKS() * shine * share);
    }
    return total;
}

Image Renderer::render(const Scene& scene) const {
    Image picture(settings());
    const Camera camera(settings());
    for (int y = 0; y < picture.height(); y++) {
        for (int x = 0; x < picture.width(); x++) {
            const Ray middle = camera.castRay(x, y);
            const Vector3 focus = middle.direction * (settings().dofFocalPlane / middle.direction.z);
            ColourRGB sum;
            for (int i = 0; i < settings().dofRayCount; i++) {
                const Vector3 lens(settings().dofAmount * randomBetween(-1, 1), settings().dofAmount * randomBetween(-1, 1), 0);
                sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
            }
            picture.set(x, y, sum * (1.0 / settings().dofRayCount));
        }
    }
    return picture;
}

}  // namespace raytracer
