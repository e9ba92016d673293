#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <cmath>
#include <vector>

namespace raytracer {

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    // first pass: how much of each light can be seen from P
    std::vector<double> share;
    for (std::size_t l = 0; l < scene.pointLights().size(); l++) {
        share.push_back(0.0);
        for (int i = 0; i < settings().shadowRayCount; i++) {
            Vector3 q = scene.pointLights()[l].position();
            q += Vector3::randomInsideUnitSphere() * settings().lightSize;
            Vector3 start = P + N * kShadowBias;
            Vector3 d = q - start;
            auto hit = scene.findClosestIntersection(Ray(start, d / d.magnitude()));
            bool blocked = false;
            if (hit) blocked = hit->distance < d.magnitude();
            if (!blocked) share[l] += 1.0;
        }
        share[l] = share[l] / settings().shadowRayCount;
    }

    // second pass: Phong
    ColourRGB c = object.colour() * scene.ambientLighting();
    Vector3 V = (O - P).normalised();
    for (std::size_t l = 0; l < scene.pointLights().size(); l++) {
        const PointLight& light = scene.pointLights()[l];
        Vector3 L = light.position() - P;
        double dist = L.magnitude();
        L = L.normalised();
        double nl = N.dot(L);
        if (nl < 0) nl = 0;
        double rv = L.reflectIn(N).dot(V);
        if (rv < 0) rv = 0;
        ColourRGB I = light.illuminationAt(dist);
        c += object.colour() * I * (object.phongKD() * nl * share[l]);
        c += light.colour() * I * (object.phongKS() * std::pow(rv, object.phongAlpha()) * share[l]);
    }
    return c;
}

Image Renderer::render(const Scene& scene) const {
    Camera cam(settings());
    Image img(settings());
    forEachPixel(img, [&](int x, int y) {
        std::vector<ColourRGB> colours;
        Ray r = cam.castRay(x, y);
        Vector3 target = r.direction * (settings().dofFocalPlane / r.direction.z);
        for (int i = 0; i < settings().dofRayCount; i++) {
            Vector3 o(settings().dofAmount * randomBetween(-1, 1),
                      settings().dofAmount * randomBetween(-1, 1), 0);
            colours.push_back(trace(scene, Ray(o, (target - o).normalised()), settings().bounces));
        }
        ColourRGB mean;
        for (std::size_t i = 0; i < colours.size(); i++) {
            mean.r += colours[i].r / colours.size();
            mean.g += colours[i].g / colours.size();
            mean.b += colours[i].b / colours.size();
        }
        img.set(x, y, mean);
    });
    return img;
}

}  // namespace raytracer
