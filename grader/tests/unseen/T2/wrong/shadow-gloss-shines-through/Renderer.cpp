#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>

namespace raytracer {
namespace {

double shadowFactor(const Scene& scene, const Vector3& start, const PointLight& light,
                    const RenderSettings& s) {
    int lit = 0;
    for (int i = 0; i < s.shadowRayCount; ++i) {
        const Vector3 way =
            light.position() + s.lightSize * Vector3::randomInsideUnitSphere() - start;
        const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
        if (!hit || hit->distance > way.magnitude()) ++lit;
    }
    return static_cast<double>(lit) / s.shadowRayCount;
}

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
        colour += diffuse * shadowFactor(scene, P + N * kShadowBias, light, settings()) + specular;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray through = camera.castRay(x, y);
        const double t = settings().dofFocalPlane / through.direction.z;
        const Vector3 target = through.origin + t * through.direction;
        const double half = settings().dofAmount / 2;  // the side is dofAmount

        ColourRGB mean;
        int done = 0;
        while (done < settings().dofRayCount) {
            const Vector3 from{randomBetween(-half, half), randomBetween(-half, half), 0};
            mean += trace(scene, {from, (target - from).normalised()}, settings().bounces);
            ++done;
        }
        mean /= done;
        image.set(x, y, mean);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
