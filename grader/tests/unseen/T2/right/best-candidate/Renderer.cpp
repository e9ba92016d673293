// Blue noise after Mitchell (1991): of a few candidates the one farthest from the points so far.
// The mean is a running one (Welford), in float; the lens is drawn before anything is traced.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace raytracer {

template <class Draw>
static std::vector<Vector3> bestCandidates(int count, Draw draw) {
    std::vector<Vector3> chosen;
    chosen.reserve(count);
    while ((int)chosen.size() < count) {
        Vector3 best;
        double farthest = -1;
        for (int c = 0; c < 4; c++) {
            Vector3 candidate = draw();
            double nearest = std::numeric_limits<double>::max();
            for (const Vector3& other : chosen) {
                Vector3 gap = candidate - other;
                nearest = std::min(nearest, gap.dot(gap));
            }
            if (nearest > farthest) {
                farthest = nearest;
                best = candidate;
            }
        }
        chosen.push_back(best);
    }
    return chosen;
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
        int reached = 0, cast = 0;
        for (const Vector3& offset :
             bestCandidates(settings().shadowRayCount, Vector3::randomInsideUnitSphere)) {
            const Vector3 start = P + N * kShadowBias;
            const Vector3 end = light.position() + offset * settings().lightSize;
            const auto hit = scene.findClosestIntersection(Ray(start, (end - start).normalised()));
            cast++;
            if (!hit || hit->distance > (end - start).magnitude()) reached++;
        }
        if (cast > 0) colour += (diffuse + specular) * (double(reached) / cast);
        // TASK T2.1 end
    }
    return colour;
}

struct RunningMean {
    float r = 0, g = 0, b = 0;
    int n = 0;
    void add(const ColourRGB& c) {
        ++n;
        r += ((float)c.r - r) / n;
        g += ((float)c.g - g) / n;
        b += ((float)c.b - b) / n;
    }
};

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray original = camera.castRay(x, y);
        const Vector3 focus = original.evaluateAt(settings().dofFocalPlane / original.direction.z);
        const double a = settings().dofAmount;
        const auto lens = bestCandidates(settings().dofRayCount, [a] {
            return Vector3(randomBetween(-a, a), randomBetween(-a, a), 0);
        });
        RunningMean mean;
        for (const Vector3& eye : lens)
            mean.add(trace(scene, Ray(eye, (focus - eye).normalised()), settings().bounces));
        image.set(x, y, {mean.r, mean.g, mean.b});
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
