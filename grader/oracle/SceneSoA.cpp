#include <grader/oracle/SceneSoA.h>

#include <cmath>
#include <numbers>

namespace ticker::oracle {
namespace {

using raytracer::Material;
using raytracer::Vector3;

float toFloat(double value) {
    return static_cast<float>(value);
}

void addSphere(SceneSoA& soa, const raytracer::SphereDescription& sphere) {
    soa.spheres.x.push_back(toFloat(sphere.centre.x));
    soa.spheres.y.push_back(toFloat(sphere.centre.y));
    soa.spheres.z.push_back(toFloat(sphere.centre.z));
    soa.spheres.radius.push_back(toFloat(sphere.radius));
    soa.normals.scale.push_back(toFloat(1.0 / sphere.radius));
    soa.normals.shiftX.push_back(toFloat(sphere.centre.x / sphere.radius));
    soa.normals.shiftY.push_back(toFloat(sphere.centre.y / sphere.radius));
    soa.normals.shiftZ.push_back(toFloat(sphere.centre.z / sphere.radius));
}

void addPlane(SceneSoA& soa, const raytracer::PlaneDescription& plane) {
    const Vector3 normal = plane.normal.normalised();
    soa.planes.x.push_back(toFloat(normal.x));
    soa.planes.y.push_back(toFloat(normal.y));
    soa.planes.z.push_back(toFloat(normal.z));
    soa.planes.offset.push_back(toFloat(normal.dot(plane.point)));
    soa.normals.scale.push_back(0.0F);
    soa.normals.shiftX.push_back(toFloat(-normal.x));
    soa.normals.shiftY.push_back(toFloat(-normal.y));
    soa.normals.shiftZ.push_back(toFloat(-normal.z));
}

void addMaterial(SceneSoA::Materials& materials, const Material& material) {
    materials.red.push_back(toFloat(material.colour.r));
    materials.green.push_back(toFloat(material.colour.g));
    materials.blue.push_back(toFloat(material.colour.b));
    materials.kD.push_back(toFloat(material.phongKD));
    materials.kS.push_back(toFloat(material.phongKS));
    materials.alpha.push_back(toFloat(material.phongAlpha));
    materials.reflectivity.push_back(toFloat(material.reflectivity));
}

int commonWholeNumber(const std::vector<float>& values) {
    constexpr float kLargest = 1024.0F;
    if (values.empty()) return 0;
    const float first = values.front();
    if (!(first >= 0.0F && first <= kLargest) || first != std::floor(first)) return -1;
    for (const float value : values)
        if (value != first) return -1;
    return static_cast<int>(first);
}

SceneSoA::Light lightOf(const raytracer::PointLight& light) {
    return {{toFloat(light.position().x), toFloat(light.position().y), toFloat(light.position().z)},
            {toFloat(light.colour().r), toFloat(light.colour().g), toFloat(light.colour().b)},
            toFloat(light.intensity() / (4.0 * std::numbers::pi))};
}

void pad(std::vector<float>& table) {
    while (table.size() % SceneSoA::kPadding != 0 || table.empty())
        table.push_back(0.0F);
}

}  // namespace

SceneSoA::SceneSoA(const raytracer::SceneDescription& scene)
    : ambient{toFloat(scene.ambientLighting.r), toFloat(scene.ambientLighting.g),
              toFloat(scene.ambientLighting.b)} {
    for (const raytracer::SphereDescription& sphere : scene.spheres) {
        addSphere(*this, sphere);
        addMaterial(materials, sphere.material);
        heightMaps.push_back(sphere.heightMap);
        anyBumpy = anyBumpy || sphere.heightMap != nullptr;
    }
    for (const raytracer::PlaneDescription& plane : scene.planes) {
        addPlane(*this, plane);
        addMaterial(materials, plane.material);
        heightMaps.push_back(nullptr);
    }
    for (const raytracer::PointLight& light : scene.pointLights)
        lights.push_back(lightOf(light));
    materials.wholeAlpha = commonWholeNumber(materials.alpha);
    for (std::vector<float>* table :
         {&normals.scale, &normals.shiftX, &normals.shiftY, &normals.shiftZ, &materials.red,
          &materials.green, &materials.blue, &materials.kD, &materials.kS, &materials.alpha,
          &materials.reflectivity})
        pad(*table);
}

}  // namespace ticker::oracle
