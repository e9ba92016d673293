#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <cmath>
#include <future>
#include <random>
#include <thread>
#include <vector>

namespace raytracer {
ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    ColourRGB colour = object.colour() * scene.ambientLighting();
    for (const PointLight& light : scene.pointLights()) {
        const Vector3 toLight = light.position() - P;
        int hits = 0;
        std::vector<Ray> rays;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 target =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            rays.push_back({P + N * kShadowBias, (target - P).normalised()});
        }
        for (const Ray& ray : rays)
            if (const auto hit = scene.findClosestIntersection(ray))
                if (hit->distance < toLight.magnitude()) ++hits;  // the distance to the centre
        const double share = 1 - hits / static_cast<double>(rays.size());
        const Vector3 L = toLight.normalised(), V = (O - P).normalised();
        const ColourRGB I = light.illuminationAt(toLight.magnitude());
        const Vector3 R = 2 * N.dot(L) * N - L;
        colour += share * (object.colour() * I * object.phongKD() * std::max(0.0, N.dot(L)) +
                           light.colour() * I * object.phongKS() *
                               std::pow(std::max(0.0, R.dot(V)), object.phongAlpha()));
    }
    return colour;
}

// Rows in bands, one task each; every band has its own engine.
Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    const int bands = std::min(4, image.height());
    std::vector<std::future<std::vector<ColourRGB>>> work;
    for (int band = 0; band < bands; ++band) {
        const int top = image.height() * band / bands, bottom = image.height() * (band + 1) / bands;
        work.push_back(std::async(std::launch::async, [&, top, bottom] {
            std::mt19937 engine{static_cast<unsigned>(settings().seed) +
                                static_cast<unsigned>(top) * 977u};
            std::uniform_real_distribution<double> square{-settings().dofAmount,
                                                          settings().dofAmount};
            std::vector<ColourRGB> out;
            for (int y = top; y < bottom; ++y)
                for (int x = 0; x < image.width(); ++x) {
                    const Ray pinhole = camera.castRay(x, y);
                    const Vector3 focus =
                        pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
                    ColourRGB sum;
                    for (int i = 0; i < settings().dofRayCount; ++i) {
                        const double lx = square(engine), ly = square(engine);
                        const Vector3 lens{lx, ly, 0};
                        sum +=
                            trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
                    }
                    out.push_back(sum / settings().dofRayCount);
                }
            return out;
        }));
    }
    int y = 0;
    for (auto& band : work) {
        const std::vector<ColourRGB> pixels = band.get();
        for (std::size_t i = 0; i < pixels.size(); ++i)
            image.set(static_cast<int>(i) % image.width(), y + static_cast<int>(i) / image.width(),
                      pixels[i]);
        y += static_cast<int>(pixels.size()) / image.width();
    }
    return image;
}
}  // namespace raytracer
