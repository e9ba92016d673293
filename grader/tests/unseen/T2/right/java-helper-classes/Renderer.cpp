// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

/** Gives random points of one spherical light. */
class LightSampler {
private:
    const PointLight& light;
    const double radius;

public:
    LightSampler(const PointLight& light, double radius) : light(light), radius(radius) {}

    Vector3 nextPoint() const {
        return light.position() + Vector3::randomInsideUnitSphere() * radius;
    }
};

/** Tests whether a point can be seen from another one. */
class VisibilityTester {
private:
    const Scene& scene;

public:
    explicit VisibilityTester(const Scene& scene) : scene(scene) {}

    bool isVisible(const Vector3& from, const Vector3& to) const {
        const Vector3 way = to - from;
        const double length = way.magnitude();
        const std::optional<RaycastHit> hit =
            scene.findClosestIntersection(Ray(from, way.normalised()));
        if (!hit.has_value()) {
            return true;
        }
        return hit->distance >= length;
    }
};

/** The lens of the camera. */
class Lens {
private:
    const double amount;

public:
    explicit Lens(double amount) : amount(amount) {}

    Vector3 nextPoint() const {
        const double x = amount * randomBetween(-1.0, 1.0);
        const double y = amount * randomBetween(-1.0, 1.0);
        return Vector3(x, y, 0.0);
    }
};

/** Collects colours and gives their average. */
class ColourAverager {
private:
    ColourRGB sum;
    int count = 0;

public:
    void add(const ColourRGB& colour) {
        sum += colour;
        count++;
    }
    ColourRGB getAverage() const { return count == 0 ? ColourRGB() : sum / count; }
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
        const LightSampler sampler(light, settings().lightSize);
        const VisibilityTester tester(scene);
        const Vector3 start = P + N * kShadowBias;
        int numVisible = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            if (tester.isVisible(start, sampler.nextPoint())) {
                numVisible++;
            }
        }
        const double proportion = (double)numVisible / (double)settings().shadowRayCount;
        colour += diffuse * proportion;
        colour += specular * proportion;
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Ray original = camera.castRay(x, y);
        const Vector3 focus =
            original.evaluateAt(settings().dofFocalPlane / original.direction.z);
        const Lens lens(settings().dofAmount);
        ColourAverager averager;
        for (int i = 0; i < settings().dofRayCount; i++) {
            const Vector3 origin = lens.nextPoint();
            const Ray ray(origin, (focus - origin).normalised());
            averager.add(trace(scene, ray, settings().bounces));
        }
        image.set(x, y, averager.getAverage());
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
