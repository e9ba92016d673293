#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>

namespace raytracer {

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 toViewer = (O - P).normalised();
    const Vector3 start = P + N * kShadowBias;
    ColourRGB colour = object.colour() * scene.ambientLighting();

    int raysCast = 0;
    int raysArrived = 0;

    for (const PointLight& light : scene.pointLights()) {
        const Vector3 toLight = (light.position() - P).normalised();
        const ColourRGB arriving =
            light.illuminationAt((light.position() - P).magnitude());
        const ColourRGB diffuse =
            object.colour() * arriving * (object.phongKD() * std::max(0.0, N.dot(toLight)));
        const double mirrored = std::max(0.0, toLight.reflectIn(N).dot(toViewer));
        const ColourRGB specular = light.colour() * arriving *
                                   (object.phongKS() * std::pow(mirrored, object.phongAlpha()));

        // TASK T2.1 begin
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 way = light.position() +
                                Vector3::randomInsideUnitSphere() * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection({start, way.normalised()});
            ++raysCast;
            if (!hit || hit->distance > way.magnitude()) ++raysArrived;
        }
        colour += (diffuse + specular) * (static_cast<double>(raysArrived) / raysCast);
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
