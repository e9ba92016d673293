// Java: Random rnd = new Random(seed);
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace raytracer {

namespace {
class Random {
  private:
    std::mt19937 engine;

  public:
    explicit Random(unsigned seed) : engine(seed) {}
    double nextDouble() { return std::uniform_real_distribution<double>(0.0, 1.0)(engine); }
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
        const Vector3 from = P + N * kShadowBias;
        double lit = 0.0;
        for (int k = settings().shadowRayCount; k-- > 0;) {
            const Vector3 way = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - from;
            const double length = way.magnitude();
            const auto blocker = scene.findClosestIntersection({from, way / length});
            lit += blocker && blocker->distance < length ? 0.0 : 1.0;
        }
        lit /= settings().shadowRayCount;
        colour += lit * diffuse + lit * specular;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        Ray centreRay = camera.castRay(x, y);
        Vector3 focalPoint = centreRay.evaluateAt(settings().dofFocalPlane / centreRay.direction.z);
        ColourRGB total = ColourRGB();
        for (int i = 0; i < settings().dofRayCount; i++) {
            Random rnd = Random(static_cast<unsigned>(y * image.width() + x));
            double lensX = (2 * rnd.nextDouble() - 1) * settings().dofAmount;
            double lensY = (2 * rnd.nextDouble() - 1) * settings().dofAmount;
            Vector3 lens = Vector3(lensX, lensY, 0);
            total += trace(scene, Ray(lens, (focalPoint - lens).normalised()), settings().bounces);
        }
        image.set(x, y, total / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
