// java.awt.Color has components from 0 to 1.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace raytracer {

namespace {
class Color {
  private:
    double r, g, b;
    static double saturate(double c) { return c < 0 ? 0 : (c > 1 ? 1 : c); }

  public:
    Color(double r, double g, double b) : r(saturate(r)), g(saturate(g)), b(saturate(b)) {}
    explicit Color(const ColourRGB& c) : Color(c.r, c.g, c.b) {}
    double getRed() const { return r; }
    double getGreen() const { return g; }
    double getBlue() const { return b; }
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
        std::vector<Color> samples;
        Ray ray = camera.castRay(x, y);
        Vector3 focal = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        while (samples.size() < static_cast<std::size_t>(settings().dofRayCount)) {
            double sx = randomBetween(-settings().dofAmount, settings().dofAmount);
            double sy = randomBetween(-settings().dofAmount, settings().dofAmount);
            Vector3 eye = Vector3(sx, sy, 0);
            samples.push_back(Color(trace(scene, Ray(eye, (focal - eye).normalised()), settings().bounces)));
        }
        double red = 0, green = 0, blue = 0;
        for (const Color& c : samples) {
            red += c.getRed();
            green += c.getGreen();
            blue += c.getBlue();
        }
        image.set(x, y, ColourRGB(red, green, blue) / samples.size());
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
