#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

// translated from Python: column = int(lon / tau * width) % width
namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const double tau = 2 * std::numbers::pi;
    const auto n = Sphere::getNormalAt(position);
    const auto lon = std::atan2(n.x, -n.z);
    const auto pol = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int width = heightMap().width();
    const int height = heightMap().height();
    const int column = std::abs(int(lon / tau * width)) % width;  // C++ needs the abs, Python did not
    const int row = std::min(int(pol / std::numbers::pi * height), height - 1);
    const auto h = [&](int c, int r) { return heightMap().at(c % width, std::min(r, height - 1)); };
    const double bu = h(column + 1, row) - h(column, row);
    const double bv = h(column, row + 1) - h(column, row);
    const Vector3 pu{std::cos(lon), 0, std::sin(lon)};
    const Vector3 pv{std::sin(lon) * std::cos(pol), -std::sin(pol), -std::cos(lon) * std::cos(pol)};
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
