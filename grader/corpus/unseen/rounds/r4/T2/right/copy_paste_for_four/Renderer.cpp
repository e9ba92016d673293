// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
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
        // unrolled by two, and one more if the number is odd
        const Vector3 s = P + N * kShadowBias;
        int yes = 0;
        for (int i = 0; i < settings().shadowRayCount / 2; i++) {
            const Vector3 t1 = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const auto h1 = scene.findClosestIntersection(Ray(s, (t1 - s).normalised()));
            if (!h1 || h1->distance > (t1 - s).magnitude()) yes++;
            const Vector3 t2 = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const auto h2 = scene.findClosestIntersection(Ray(s, (t2 - s).normalised()));
            if (!h2 || h2->distance > (t2 - s).magnitude()) yes++;
        }
        if (settings().shadowRayCount % 2 == 1) {
            const Vector3 t3 = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const auto h3 = scene.findClosestIntersection(Ray(s, (t3 - s).normalised()));
            if (!h3 || h3->distance > (t3 - s).magnitude()) yes++;
        }
        colour += (diffuse + specular) * (1.0 * yes / settings().shadowRayCount);
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
        const Vector3 f = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        const double a = settings().dofAmount;
        ColourRGB s1, s2, s3, s4;
        int cast = 0;
        // four at a time, one in each quarter of the lens, so up to three more than asked for
        while (cast < settings().dofRayCount) {
            const Vector3 e1(randomBetween(0, a), randomBetween(0, a), 0);
            const Vector3 e2(randomBetween(-a, 0), randomBetween(0, a), 0);
            const Vector3 e3(randomBetween(0, a), randomBetween(-a, 0), 0);
            const Vector3 e4(randomBetween(-a, 0), randomBetween(-a, 0), 0);
            s1 += trace(scene, Ray(e1, (f - e1).normalised()), settings().bounces);
            s2 += trace(scene, Ray(e2, (f - e2).normalised()), settings().bounces);
            s3 += trace(scene, Ray(e3, (f - e3).normalised()), settings().bounces);
            s4 += trace(scene, Ray(e4, (f - e4).normalised()), settings().bounces);
            cast += 4;
        }
        image.set(x, y, (s1 + s2 + s3 + s4) / cast);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
