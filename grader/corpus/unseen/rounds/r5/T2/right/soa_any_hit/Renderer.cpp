// Shadow rays need no nearest hit: any will do. Own loop, and the last blocker is asked first.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace raytracer {

namespace {

struct Packet {  // structure of arrays
    std::vector<double> x, y, z;
    explicit Packet(int n) : x(n), y(n), z(n) {}
    void put(int i, const Vector3& v) { x[i] = v.x; y[i] = v.y; z[i] = v.z; }
    [[nodiscard]] Vector3 get(int i) const { return {x[i], y[i], z[i]}; }
};

/// Whether something lies between; remembers what did, for the next ray of the same light.
class Blockers {
public:
    explicit Blockers(const Scene& scene) : scene_(scene) {}
    bool between(const Vector3& from, const Vector3& to) {
        const Ray ray{from, to - from};  // the light is at distance 1
        if (last_ != nullptr && blocks(*last_, ray)) return true;
        for (const auto& object : scene_.objects()) {
            if (object.get() != last_ && blocks(*object, ray)) {
                last_ = object.get();
                return true;
            }
        }
        return false;
    }

private:
    static bool blocks(const SceneObject& object, const Ray& ray) {
        const auto hit = object.intersectionWith(ray);
        return hit && hit->distance < 1.0;
    }
    const Scene& scene_;
    const SceneObject* last_ = nullptr;
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
        const int n = settings().shadowRayCount;
        Packet aims{n};
        for (int i = 0; i < n; ++i) aims.put(i, Vector3::randomInsideUnitSphere());
        for (double& v : aims.x) v = v * settings().lightSize + light.position().x;
        for (double& v : aims.y) v = v * settings().lightSize + light.position().y;
        for (double& v : aims.z) v = v * settings().lightSize + light.position().z;
        Blockers blockers{scene};
        int free = 0;
        for (int i = 0; i < n; ++i)
            if (!blockers.between(P + N * kShadowBias, aims.get(i))) ++free;
        colour += (diffuse + specular) * (free * 1.0 / n);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 F = d * (settings().dofFocalPlane / d.z);
        const int n = settings().dofRayCount;
        ColourRGB mean;
        for (int i = 0; i < n; ++i) {
            Vector3 lens;
            lens.x = settings().dofAmount * randomBetween(-1.0, 1.0);
            lens.y = settings().dofAmount * randomBetween(-1.0, 1.0);
            mean += trace(scene, {lens, (F - lens).normalised()}, settings().bounces) * (1.0 / n);
        }
        image.set(x, y, mean);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
