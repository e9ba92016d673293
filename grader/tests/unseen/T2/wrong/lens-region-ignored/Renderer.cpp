// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

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
        double lightFraction = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            const Vector3 o = P + N * kShadowBias;
            const Vector3 way =
                light.position() + settings().lightSize * Vector3::randomInsideUnitSphere() - o;
            const auto occluder = scene.findClosestIntersection(Ray{o, way});  // 1 is the light
            if (!occluder || occluder->distance > 1) lightFraction += 1.0 / settings().shadowRayCount;
        }
        colour += diffuse * lightFraction;
        colour += specular * lightFraction;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    // TASK T2.2 begin
    // no forEachPixel: I prefer two plain loops over all pixels of the picture
    Camera camera(settings());
    Image image(settings());
    for (int y = 0; y < settings().height; y++) {
        for (int x = 0; x < settings().width; x++) {
            Ray ray = camera.castRay(x, y);
            Vector3 focal = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
            ColourRGB colour;
            for (int i = 0; i < settings().dofRayCount; i++) {
                Vector3 origin(randomBetween(-1, 1) * settings().dofAmount,
                               randomBetween(-1, 1) * settings().dofAmount, 0);
                colour += trace(scene, Ray(origin, (focal - origin).normalised()),
                                settings().bounces);
            }
            colour /= settings().dofRayCount;
            image.set(x, y, colour);
        }
    }
    return image;
    // TASK T2.2 end
}

}  // namespace raytracer
