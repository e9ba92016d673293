#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <cmath>
using namespace std;

namespace raytracer {

double max0(double a) {
    if (a > 0) return a;
    return 0;
}

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    ColourRGB result = object.colour() * scene.ambientLighting();
    Vector3 V = (O - P).normalised();
    for (int a = 0; a < (int)scene.pointLights().size(); a++) {
        PointLight light = scene.pointLights()[a];
        Vector3 L = (light.position() - P).normalised();
        Vector3 R = 2 * N.dot(L) * N - L;
        double d = (light.position() - P).magnitude();
        double kd = object.phongKD() * max0(N.dot(L));
        double ks = object.phongKS() * pow(max0(R.dot(V)), object.phongAlpha());
        ColourRGB diffuse = object.colour() * light.illuminationAt(d) * kd;
        ColourRGB specular = light.colour() * light.illuminationAt(d) * ks;

        int good = 0;
        for (int b = 0; b < settings().shadowRayCount; b++) {
            Vector3 start = P + N * kShadowBias;
            Vector3 end = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            Ray ray(start, (end - start).normalised());
            auto hit = scene.findClosestIntersection(ray);
            if (!hit) {
                good++;
            } else {
                if (hit->distance > (end - start).magnitude()) {
                    good++;
                }
            }
        }
        double factor = double(good) / double(settings().shadowRayCount);
        result.r = result.r + factor * (diffuse.r + specular.r);
        result.g = result.g + factor * (diffuse.g + specular.g);
        result.b = result.b + factor * (diffuse.b + specular.b);
    }
    return result;
}

Image Renderer::render(const Scene& scene) const {
    Camera camera(settings());
    Image image(settings());
    for (int y = 0; y < image.height(); y++) {
        for (int x = 0; x < image.width(); x++) {
            Ray ray = camera.castRay(x, y);
            Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
            ColourRGB sum(0);
            for (int i = 0; i < settings().dofRayCount; i++) {
                Vector3 eye;
                eye.x = randomBetween(-1, 1) * settings().dofAmount;
                eye.y = randomBetween(-1, 1) * settings().dofAmount;
                eye.z = 0;
                ColourRGB c = trace(scene, Ray(eye, (focus - eye).normalised()), settings().bounces);
                sum = sum + c;
            }
            image.set(x, y, sum / settings().dofRayCount);
        }
    }
    return image;
}

}  // namespace raytracer
