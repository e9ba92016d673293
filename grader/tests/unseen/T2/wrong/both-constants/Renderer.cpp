// The constants of the printed handout
// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

// Distributed shadow ray constants
static const int SHADOW_RAY_COUNT = 10;  // no. of spawned shadow rays
static const double LIGHT_SIZE = 0.4;    // size of spherical light source

// Distributed depth-of-field constants
static const int DOF_RAY_COUNT = 50;          // no. of spawned DoF rays
static const double DOF_FOCAL_PLANE = 3.51805;  // focal length of camera
static const double DOF_AMOUNT = 0.2;         // amount of DoF effect

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
        double shadowRaysArrived = 0;
        for (int i = 0; i < SHADOW_RAY_COUNT; i++) {
            Vector3 origin = P + N * kShadowBias;
            Vector3 target = light.position() + Vector3::randomInsideUnitSphere() * LIGHT_SIZE;
            Ray shadowRay{origin, (target - origin).normalised()};
            auto hit = scene.findClosestIntersection(shadowRay);
            if (!hit || hit->distance > (target - origin).magnitude()) shadowRaysArrived++;
        }
        colour += (diffuse + specular) * (shadowRaysArrived / SHADOW_RAY_COUNT);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        Ray ray = camera.castRay(x, y);
        Vector3 focal = ray.evaluateAt(DOF_FOCAL_PLANE / ray.direction.z);
        ColourRGB sum;
        for (int i = 0; i < DOF_RAY_COUNT; i++) {
            Vector3 origin{DOF_AMOUNT * randomBetween(-1, 1), DOF_AMOUNT * randomBetween(-1, 1), 0};
            sum += trace(scene, Ray{origin, (focal - origin).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / DOF_RAY_COUNT);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
