#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace raytracer {

namespace { struct Rays { std::vector<double> ox, oy, dx, dy, dz; }; }

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

        std::vector<char> visible(static_cast<std::size_t>(settings().shadowRayCount), 1);
        const Vector3 start = P + toLight * kShadowBias;
        for (char& v : visible) {
            const Ray probe{start, (light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start).normalised()};
            if (const auto hit = scene.findClosestIntersection(probe)) v = hit->distance > distance;
        }
        const double share = static_cast<double>(std::count(visible.begin(), visible.end(), 1)) / static_cast<double>(visible.size());
        colour += diffuse * share;
        colour += specular * share;
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        thread_local Rays rays;
        const std::size_t n = static_cast<std::size_t>(settings().dofRayCount);
        rays.ox.resize(n); rays.oy.resize(n); rays.dx.resize(n); rays.dy.resize(n); rays.dz.resize(n);
        const Ray middle = camera.castRay(x, y);
        for (double& v : rays.ox) v = randomBetween(-settings().dofAmount, settings().dofAmount);
        for (double& v : rays.oy) v = randomBetween(-settings().dofAmount, settings().dofAmount);
        for (std::size_t i = 0; i < n; ++i) {
            rays.dx[i] = middle.direction.x / middle.direction.z * settings().dofFocalPlane - rays.ox[i];
            rays.dy[i] = middle.direction.y / middle.direction.z * settings().dofFocalPlane - rays.oy[i];
            rays.dz[i] = settings().dofFocalPlane;
        }
        ColourRGB c;
        for (std::size_t i = n; i-- > 0;)
            c += trace(scene, Ray{{rays.ox[i], rays.oy[i], 0}, Vector3{rays.dx[i], rays.dy[i], rays.dz[i]}.normalised()}, settings().bounces);
        image.set(x, y, c / static_cast<double>(n));
    });
    return image;
}

}  // namespace raytracer
