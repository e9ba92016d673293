#include "SceneWords.h"

#include <raytracer/image/ToneCurve.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>

namespace raytracer {

std::string nameOf(const Scene& scene, const SceneObject* object) {
    std::map<std::string, int> seen;
    for (const auto& candidate : scene.objects()) {
        std::string kind = "sphere";
        if (dynamic_cast<const Plane*>(candidate.get()) != nullptr) kind = "plane";
        if (dynamic_cast<const BumpySphere*>(candidate.get()) != nullptr) kind = "bumpy sphere";
        const int place = ++seen[kind];
        if (candidate.get() == object) return kind + " " + std::to_string(place);
    }
    return "an object";
}

std::size_t aimOf(const Scene& scene, const Ray& ray) {
    std::size_t best = 0;
    double most = -2.0;
    for (std::size_t i = 0; i < scene.pointLights().size(); ++i) {
        const Vector3 towards = scene.pointLights()[i].position() - ray.origin;
        const double cosine = towards.normalised().dot(ray.direction.normalised());
        if (cosine > most) {
            most = cosine;
            best = i;
        }
    }
    return best;
}

bool isStopped(const SeenRay& seen, const PointLight& light) {
    const double reach = (light.position() - seen.ray.origin).magnitude();
    return seen.hit && seen.hit->distance * seen.ray.direction.magnitude() < reach;
}

std::string numberText(double value) {
    // Smaller values, such as powers of small cosines, are invisible.
    constexpr double kNothing = 1e-9;
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", std::abs(value) < kNothing ? 0.0 : value);
    return text.data();
}

std::string tripleText(const Vector3& v) {
    return "(" + numberText(v.x) + ", " + numberText(v.y) + ", " + numberText(v.z) + ")";
}

std::string tripleText(const ColourRGB& colour) {
    return tripleText(Vector3{colour.r, colour.g, colour.b});
}

std::string hexOf(const ColourRGB& colour) {
    const std::array<std::uint8_t, 3> bytes = toneMapped(colour);
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02X%02X%02X", bytes[0], bytes[1], bytes[2]);
    return text.data();
}

std::string countedText(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string arrivingText(std::size_t rays) {
    return std::to_string(rays) + (rays == 1 ? " arrives" : " arrive");
}

}  // namespace raytracer
