// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace raytracer {

static float uniform01() {
    thread_local std::mt19937 generator{std::random_device{}()};
    thread_local std::uniform_real_distribution<float> distribution(0.0f, 1.0f);
    return distribution(generator);
}

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
        float part = 0.0f;
        for (int s = 0; s < settings().shadowRayCount; s++) {
            // spherical coordinates with the cube root, so that the ball is filled evenly
            float r = std::cbrt(uniform01()) * (float)settings().lightSize;
            float cosT = 1.0f - 2.0f * uniform01();
            float sinT = std::sqrt(1.0f - cosT * cosT);
            float phi = 6.2831853f * uniform01();
            Vector3 target = light.position() +
                             Vector3(r * sinT * std::cos(phi), r * cosT, r * sinT * std::sin(phi));
            Vector3 start = P + N * kShadowBias;
            Vector3 dir = target - start;
            auto block = scene.findClosestIntersection(Ray(start, dir.normalised()));
            if (block && block->distance < dir.magnitude()) continue;
            part += 1.0f / settings().shadowRayCount;
        }
        colour += (diffuse + specular) * part;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        Ray pinhole = camera.castRay(x, y);
        float scale = (float)(settings().dofFocalPlane / pinhole.direction.z);
        Vector3 focal = pinhole.evaluateAt(scale);
        float r = 0, g = 0, b = 0;
        for (int s = 0; s < settings().dofRayCount; s++) {
            float lx = (2.0f * uniform01() - 1.0f) * (float)settings().dofAmount;
            float ly = (2.0f * uniform01() - 1.0f) * (float)settings().dofAmount;
            Vector3 lens(lx, ly, 0);
            ColourRGB c = trace(scene, Ray(lens, (focal - lens).normalised()), settings().bounces);
            r += (float)c.r;
            g += (float)c.g;
            b += (float)c.b;
        }
        image.set(x, y, ColourRGB(r, g, b) / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
