#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <cmath>
#include <random>

namespace raytracer {
namespace {
std::mt19937_64& engine() {
    static thread_local std::mt19937_64 instance{std::random_device{}()};
    return instance;
}
double uniform() {
    return std::uniform_real_distribution<double>{-1.0, 1.0}(engine());
}

Vector3 inBall() {
    for (;;) {
        const Vector3 v{uniform(), uniform(), uniform()};
        if (v.dot(v) < 1.0) return v;
    }
}
}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    ColourRGB result = scene.ambientLighting() * object.colour();
    const Vector3 V = (O - P).normalised();
    for (const auto& light : scene.pointLights()) {
        int visible = 0;
        for (int k = settings().shadowRayCount; k-- > 0;) {
            const Vector3 aim = light.position() + settings().lightSize * inBall();
            const Vector3 start = P + kShadowBias * N;
            const double far = (aim - start).magnitude();
            const auto hit = scene.findClosestIntersection({start, (aim - start) / far});
            visible += !(hit.has_value() && hit->distance < far);
        }
        const double d = (light.position() - P).magnitude();
        const Vector3 L = (light.position() - P) / d;
        const ColourRGB I = light.illuminationAt(d);
        const double share = double(visible) / settings().shadowRayCount;
        result += share * object.phongKD() * std::max(0.0, N.dot(L)) * (object.colour() * I);
        result += share * object.phongKS() *
                  std::pow(std::max(0.0, L.reflectIn(N).dot(V)), object.phongAlpha()) *
                  (light.colour() * I);
    }
    return result;
}

// Plain loops; the square is cut into cells and every cell gets a jittered point.
Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    const int side = static_cast<int>(std::ceil(std::sqrt(settings().dofRayCount)));
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            engine().seed(settings().seed * 7919u + static_cast<unsigned>(y * 65536 + x));
            const Ray through = camera.castRay(x, y);
            const Vector3 focus =
                through.direction * (settings().dofFocalPlane / through.direction.z);
            ColourRGB total;
            for (int i = 0; i < side; ++i)
                for (int j = 0; j < side; ++j) {
                    const double a = (i + (uniform() + 1) / 2) / side * 2 - 1;
                    const double b = (j + (uniform() + 1) / 2) / side * 2 - 1;
                    const Vector3 from{a * settings().dofAmount, b * settings().dofAmount, 0};
                    total += trace(scene, {from, (focus - from).normalised()}, settings().bounces);
                }
            image.set(x, y, total / (side * side));
        }
    }
    return image;
}
}  // namespace raytracer
