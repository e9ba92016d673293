#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>

namespace raytracer {

/** An average of colours. Colours go from 0 to 1, so brighter ones are cut. */
class AverageColour {
public:
    void add(const ColourRGB& c) {
        total_ += ColourRGB{std::min(c.r, 1.0), std::min(c.g, 1.0), std::min(c.b, 1.0)};
        ++n_;
    }
    ColourRGB get() const { return total_ / n_; }

private:
    ColourRGB total_;
    int n_ = 0;
};

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
        int shadowed = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            Vector3 randomPoint = Vector3::randomInsideUnitSphere() * settings().lightSize;
            Vector3 lightPoint = light.position() + randomPoint;
            Vector3 rayOrigin = P + N * kShadowBias;
            Ray shadowRay(rayOrigin, (lightPoint - rayOrigin).normalised());
            std::optional<RaycastHit> hit = scene.findClosestIntersection(shadowRay);
            if (hit.has_value() && hit->distance < (lightPoint - rayOrigin).magnitude()) {
                shadowed = shadowed + 1;
            }
        }
        double inShadow = (double)shadowed / (double)settings().shadowRayCount;
        colour += (diffuse + specular) * (1.0 - inShadow);
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
        const Vector3 focus = d * (settings().dofFocalPlane / d.z);
        AverageColour average;
        for (int i = 0; i < settings().dofRayCount; i++) {
            const Vector3 eye(settings().dofAmount * randomBetween(-1, 1),
                              settings().dofAmount * randomBetween(-1, 1), 0);
            average.add(trace(scene, Ray(eye, (focus - eye).normalised()), settings().bounces));
        }
        image.set(x, y, average.get());
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
