// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

// Height between texel centres; goes round the sphere in x, stops at the poles in y.
double sampleHeight(const HeightMap& map, double x, double y) {
    x -= 0.5;
    y = std::clamp(y - 0.5, 0.0, map.height() - 1.0);
    const double left = std::floor(x);
    const int row = std::min(static_cast<int>(y), map.height() - 2);
    const double fx = x - left;
    const double fy = y - row;
    const int w = map.width();
    const int column = ((static_cast<int>(left) % w) + w) % w;
    const int next = (column + 1) % w;
    const double top = map.at(column, row) * (1.0 - fx) + map.at(next, row) * fx;
    const double bottom = map.at(column, row + 1) * (1.0 - fx) + map.at(next, row + 1) * fx;
    return top * (1.0 - fy) + bottom * fy;
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double phi = std::atan2(n.z, n.x);  // anticlockwise seen from above

    const HeightMap& map = heightMap();
    const double x = phi / (2.0 * std::numbers::pi) * map.width();
    const double y = theta / std::numbers::pi * map.height();
    const double Bu = (sampleHeight(map, x + 1.0, y) - sampleHeight(map, x - 1.0, y)) / 2.0;
    const double Bv = (sampleHeight(map, x, y + 1.0) - sampleHeight(map, x, y - 1.0)) / 2.0;

    // Derivatives of (sin theta cos phi, cos theta, sin theta sin phi), not normalised.
    const Vector3 Pu{-n.z, 0.0, n.x};
    const Vector3 Pv{std::cos(theta) * std::cos(phi), -std::sin(theta),
                     std::cos(theta) * std::sin(phi)};
    return (n - Pu * Bu - Pv * Bv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
