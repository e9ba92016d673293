// The light points are drawn once per pixel in render() and used for all rays of that pixel: a
// tenth of the random numbers.
// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace raytracer {

static thread_local std::vector<Vector3> lightOffsets;

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
        int visible = 0;
        for (const Vector3& offset : lightOffsets) {
            const Vector3 start = P + N * kShadowBias;
            const Vector3 way = light.position() + offset * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection({start, way.normalised()});
            if (!hit || hit->distance > way.magnitude()) visible++;
        }
        colour += (diffuse + specular) * (static_cast<double>(visible) / settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray ray = camera.castRay(x, y);
        const Vector3 focal = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        lightOffsets.clear();
        for (int i = 0; i < settings().shadowRayCount; i++)
            lightOffsets.push_back(Vector3::randomInsideUnitSphere());

        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; i++) {
            const Vector3 eye(randomBetween(-1, 1) * settings().dofAmount,
                              randomBetween(-1, 1) * settings().dofAmount, 0);
            sum += trace(scene, Ray(eye, (focal - eye).normalised()), settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
