// R2 sequence (Roberts) with a random start for each pixel.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {
class R2 {
public:
    R2() : a_(randomBetween(0, 1)), b_(randomBetween(0, 1)) {}
    Vector3 next() {
        a_ += 0.7548776662466927;
        b_ += 0.5698402909980532;
        a_ -= std::floor(a_);
        b_ -= std::floor(b_);
        return {a_, b_, 0.0};
    }

private:
    double a_, b_;
};
}  // namespace

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
        const Vector3 from = P + N * kShadowBias;
        double lit = 0.0;
        for (int k = settings().shadowRayCount; k-- > 0;) {
            const Vector3 way = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - from;
            const double length = way.magnitude();
            const auto blocker = scene.findClosestIntersection({from, way / length});
            lit += blocker && blocker->distance < length ? 0.0 : 1.0;
        }
        lit /= settings().shadowRayCount;
        colour += lit * diffuse + lit * specular;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        R2 sequence;
        const Ray pinhole = camera.castRay(x, y);
        const Vector3 focus = pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens = sequence.next() * settings().dofAmount;
            sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
