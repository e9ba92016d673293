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
        // stratified: the ball is cut into shells, one ray for each
        int n = settings().shadowRayCount;
        int reached = 0;
        for (int i = 0; i < n; i++) {
            Vector3 dir;
            do {
                dir = Vector3(randomBetween(-1, 1), randomBetween(-1, 1), randomBetween(-1, 1));
            } while (dir.magnitude() > 1 || dir.magnitude() < 0.001);
            double r = std::cbrt((i + randomBetween(0, 1)) / n);
            Vector3 target = light.position() + dir.normalised() * (r * settings().lightSize);
            Vector3 start = P + N * kShadowBias;
            auto hit = scene.findClosestIntersection({start, (target - start).normalised()});
            if (!hit || hit->distance > (target - start).magnitude()) reached++;
        }
        colour += (diffuse + specular) * ((double)reached / n);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        // as many rays as fit in a square grid, at least dofRayCount: 8 x 8 for 50
        int side = 1;
        while (side * side < settings().dofRayCount) side++;

        Ray ray = camera.castRay(x, y);
        Vector3 focal = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        double cell = 2 * settings().dofAmount / side;
        ColourRGB sum;
        for (int i = 0; i < side; i++) {
            for (int j = 0; j < side; j++) {
                double lx = -settings().dofAmount + (i + randomBetween(0, 1)) * cell;
                double ly = -settings().dofAmount + (j + randomBetween(0, 1)) * cell;
                Vector3 lens(lx, ly, 0);
                sum += trace(scene, {lens, (focal - lens).normalised()}, settings().bounces);
            }
        }
        image.set(x, y, sum / (side * side));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
