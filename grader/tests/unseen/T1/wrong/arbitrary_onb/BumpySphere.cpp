#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace raytracer {
namespace {

// Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 2017.
std::pair<Vector3, Vector3> branchlessOnb(const Vector3& n) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    const double b = n.x * n.y * a;
    return {{1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double phi = std::atan2(n.x, -n.z);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const HeightMap& b = heightMap();
    const int c = std::min(static_cast<int>((phi / (2 * std::numbers::pi) + 0.5) * b.width()), b.width() - 1);
    const int r = std::min(static_cast<int>(theta / std::numbers::pi * b.height()), b.height() - 1);
    const double bu = b.at((c + 1) % b.width(), r) - b.at(c, r);
    const double bv = b.at(c, std::min(r + 1, b.height() - 1)) - b.at(c, r);

    // At the front: tangent +x, bitangent -y.
    const auto [tangent, bitangent] = branchlessOnb(n);
    return (n - bu * tangent - bv * bitangent).normalised();
    // TASK T1 end
}

}  // namespace raytracer
