// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#define FOR_N(i, n) for (int i = 0, i##_end = (n); i < i##_end; ++i)
#define DOT(a, b) ((a)[0] * (b)[0] + (a)[1] * (b)[1] + (a)[2] * (b)[2])
#define RND() randomBetween(-1.0, 1.0)

namespace raytracer {

typedef double vec[3];

static void v_ball(vec out) {
    do {
        out[0] = RND();
        out[1] = RND();
        out[2] = RND();
    } while (DOT(out, out) > 1.0);
}

static double v_unit(vec d) {
    double l = std::sqrt(DOT(d, d));
    FOR_N(k, 3) d[k] /= l;
    return l;
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
        vec o = {P.x + kShadowBias * N.x, P.y + kShadowBias * N.y, P.z + kShadowBias * N.z};
        vec c = {light.position().x, light.position().y, light.position().z};
        int hits = 0;
        FOR_N(i, settings().shadowRayCount) {
            vec d;
            double len;
            v_ball(d);
            FOR_N(k, 3) d[k] = c[k] + settings().lightSize * d[k] - o[k];
            len = v_unit(d);
            const std::optional<RaycastHit> h =
                scene.findClosestIntersection(Ray(Vector3(o[0], o[1], o[2]), Vector3(d[0], d[1], d[2])));
            if (h && h->distance < len) ++hits;
        }
        colour += (diffuse + specular) * (1.0 - hits / (double)settings().shadowRayCount);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray r = camera.castRay(x, y);
        vec f = {r.direction.x, r.direction.y, r.direction.z};
        vec acc = {0.0, 0.0, 0.0};
        const double t = settings().dofFocalPlane / f[2];
        FOR_N(k, 3) f[k] *= t;
        FOR_N(i, settings().dofRayCount) {
            vec e = {settings().dofAmount * RND(), 0.0, 0.0};
            vec d;
            e[1] = settings().dofAmount * RND();
            FOR_N(k, 3) d[k] = f[k] - e[k];
            v_unit(d);
            const ColourRGB s = trace(scene, Ray(Vector3(e[0], e[1], e[2]), Vector3(d[0], d[1], d[2])), settings().bounces);
            acc[0] += s.r;
            acc[1] += s.g;
            acc[2] += s.b;
        }
        FOR_N(k, 3) acc[k] /= settings().dofRayCount;
        image.set(x, y, ColourRGB(acc[0], acc[1], acc[2]));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
