#include <shadows/Room.h>

#include <algorithm>
#include <cmath>

namespace raytracer::tests::shadows {

Material floorMaterial() {
    Material material;
    material.colour = {0.8, 0.5, 0.3};
    material.phongKD = 0.7;
    material.phongKS = 1.1;
    material.phongAlpha = 4.0;
    return material;
}

SceneDescription emptyRoom() {
    SceneDescription scene;
    scene.ambientLighting = kAmbient;
    scene.pointLights.emplace_back(kLight, ColourRGB{0.9, 0.7, 0.5}, 420.0);
    scene.planes.push_back({kFoot, kUp, floorMaterial()});
    return scene;
}

SceneDescription roomWithBall() {
    SceneDescription scene = emptyRoom();
    scene.spheres.push_back({kBall, kBallRadius, floorMaterial(), nullptr});
    return scene;
}
Vector3 floorAt(double right) {
    return kFoot + Vector3{right, 0.0, 0.0};
}

Vector3 floorWhereLightIsClearBy(double clear) {
    double low = 0.0;
    double high = 20.0;
    for (int i = 0; i < 80; ++i) {
        const double right = 0.5 * (low + high);
        const Vector3 point = floorAt(right);
        const Vector3 toBall = kBall - point;
        const double rim = std::asin(kBallRadius / toBall.magnitude());
        const Vector3 toLight = kLight - point;
        const double apart =
            std::acos(std::clamp(toBall.normalised().dot(toLight.normalised()), -1.0, 1.0));
        (toLight.magnitude() * std::sin(apart - rim) < clear ? low : high) = right;
    }
    return floorAt(low);
}

ColourRGB ambientOnly() {
    return floorMaterial().colour * kAmbient;
}

questions::PhongTerms unshadowed(const SceneDescription& scene, std::size_t light,
                                 const Vector3& point) {
    const PointLight& lamp = scene.pointLights[light];
    const Vector3 path = lamp.position() - point;
    return questions::phongTerms(floorMaterial(), lamp, kUp, (kEye - point).normalised(),
                                 path.normalised(), path.magnitude());
}

double shareOf(const ColourRGB& colour, const Vector3& point) {
    const double full = unshadowed(roomWithBall(), 0, point).sum().g;
    return (colour.g - ambientOnly().g) / full;
}

}  // namespace raytracer::tests::shadows
