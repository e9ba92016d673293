#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <array>

namespace raytracer {
namespace {

using double4 = double __attribute__((vector_size(32)));

/// Four ways from one start to the light; the parameter runs from 0 to 1 along each.
struct Packet {
    double4 x, y, z;
};

void meetSphere(const Sphere& sphere, const Vector3& start, const Packet& way, std::array<bool, 4>& blocked) {
    const Vector3 o = start - sphere.centre();
    const double4 a = way.x * way.x + way.y * way.y + way.z * way.z;
    const double4 b = o.x * way.x + o.y * way.y + o.z * way.z;
    const double c = o.dot(o) - sphere.radius() * sphere.radius();
    const double4 d = b * b - a * c;
    for (int k = 0; k < 4; ++k) {
        if (d[k] < 0.0) continue;
        const double root = std::sqrt(d[k]);
        const double near = (-b[k] - root) / a[k];
        const double far = (-b[k] + root) / a[k];
        if ((near > 0.0 && near < 1.0) || (far > 0.0 && far < 1.0)) blocked[k] = true;
    }
}

void meetPlane(const Plane& plane, const Vector3& start, const Packet& way, std::array<bool, 4>& blocked) {
    const Vector3& n = plane.normal();
    const double height = (plane.point() - start).dot(n);
    const double4 descent = way.x * n.x + way.y * n.y + way.z * n.z;
    for (int k = 0; k < 4; ++k) {
        if (descent[k] == 0.0) continue;
        const double t = height / descent[k];
        if (t > 0.0 && t < 1.0) blocked[k] = true;
    }
}

std::array<bool, 4> blockedLanes(const Scene& scene, const Vector3& start, const Packet& way) {
    std::array<bool, 4> blocked{};
    for (const auto& object : scene.objects()) {
        if (const auto* sphere = dynamic_cast<const Sphere*>(object.get())) meetSphere(*sphere, start, way, blocked);
        if (const auto* plane = dynamic_cast<const Plane*>(object.get())) meetPlane(*plane, start, way, blocked);
    }
    return blocked;
}

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
        const Vector3 start = P + N * kShadowBias;
        int clear = 0;
        for (int done = 0; done < settings().shadowRayCount; done += 4) {
            const int lanes = std::min(4, settings().shadowRayCount - done);
            Packet to{};
            for (int k = 0; k < lanes; ++k) {
                const Vector3 way = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
                to.x[k] = way.x;
                to.y[k] = way.y;
                to.z[k] = way.z;
            }
            for (int k = lanes; k < 4; ++k) to.z[k] = 1.0;
            const std::array<bool, 4> blocked = blockedLanes(scene, start, to);
            for (int k = 0; k < lanes; ++k) clear += blocked[k] ? 0 : 1;
        }
        colour += (diffuse + specular) * (clear / static_cast<double>(settings().shadowRayCount));
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const Vector3 d = camera.castRay(x, y).direction;
        const Vector3 focus = d / d.z * settings().dofFocalPlane;
        double4 sum{};
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens{settings().dofAmount * randomBetween(-1, 1), settings().dofAmount * randomBetween(-1, 1), 0};
            const ColourRGB c = trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
            sum += double4{c.r, c.g, c.b, 0.0};
        }
        sum /= static_cast<double>(settings().dofRayCount);
        image.set(x, y, {sum[0], sum[1], sum[2]});
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
