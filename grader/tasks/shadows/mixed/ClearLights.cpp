#include <grader/tasks/shadows/mixed/ClearLights.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ticker::tasks {
namespace {

using raytracer::PointLight;
using raytracer::Vector3;

double sizeSeen(const PointLight& light, const Vector3& point, double lightSize) {
    constexpr double kLarger = 1.1;
    return std::asin(std::min(1.0, kLarger * lightSize / (light.position() - point).magnitude()));
}

}  // namespace

bool areApart(const PointLight& one, const PointLight& other, const Vector3& point,
              double lightSize) {
    constexpr double kGap = 0.15;
    constexpr double kOfDirection = 0.03;
    const double cosine =
        (one.position() - point).normalised().dot((other.position() - point).normalised());
    const double apart = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double first = sizeSeen(one, point, lightSize);
    const double second = sizeSeen(other, point, lightSize);
    // A ray counts for the light whose centre is nearest to its direction. So no light's rim may be
    // nearer to another light's centre than to its own.
    return apart > first + second + kGap && apart > 2.0 * std::max(first, second) + kOfDirection;
}

bool isOffHorizon(const PointLight& light, const Vector3& point, const Vector3& normal,
                  double lightSize) {
    constexpr double kLarger = 1.45;  // light sizes; `zonesOf` takes 1.33
    constexpr double kLeastCosine = 0.15;
    const Vector3 towards = light.position() - point;
    const double height = std::abs(towards.dot(normal));
    return height > kLarger * lightSize && height > kLeastCosine * towards.magnitude();
}

bool isFarOff(const PointLight& light, const Vector3& point, double lightSize) {
    constexpr double kSeenFrom = 0.53;
    return (light.position() - point).magnitude() > lightSize + kSeenFrom;
}

bool showsNoHighlightFromBehind(const PointLight& light, const Vector3& point,
                                const Vector3& normal, const Vector3& viewer, double lightSize) {
    constexpr double kOffEdge = 0.05;  // radians
    const Vector3 L = (light.position() - point).normalised();
    if (L.dot(normal) > 0.0) return true;
    const double cosine = L.reflectIn(normal).dot((viewer - point).normalised());
    const double nearest =
        std::acos(std::clamp(cosine, -1.0, 1.0)) - sizeSeen(light, point, lightSize);
    return nearest > std::numbers::pi / 2.0 + kOffEdge;
}

}  // namespace ticker::tasks
