// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    // Step 1: the smooth normal, and spherical polar coordinates on it: the longitude grows to the
    // right and is 0 in front, the polar angle grows downwards from the top.
    const Vector3 normal = Sphere::getNormalAt(position);
    const double longitude = std::atan2(normal.x, -normal.z);
    const double polarAngle = std::acos(std::clamp(normal.y, -1.0, 1.0));
    const double u = longitude / (2.0 * std::numbers::pi) + 0.5;
    const double v = polarAngle / std::numbers::pi;

    // Step 2: unit tangents, the derivatives of the point by u and by v: Pu points to the right,
    // Pv downwards, and Pu x Pv is the normal.
    const Vector3 Pu{std::cos(longitude), 0.0, std::sin(longitude)};
    const Vector3 Pv{std::sin(longitude) * std::cos(polarAngle), -std::sin(polarAngle),
                     -std::cos(longitude) * std::cos(polarAngle)};

    // Step 3: slopes, the texel to the right or below minus this one. Columns go round the sphere;
    // below the last row there is nothing, so it is flat downwards.
    const HeightMap& map = heightMap();
    const int column = std::min(static_cast<int>(u * map.width()), map.width() - 1);
    const int row = std::min(static_cast<int>(v * map.height()), map.height() - 1);
    thread_local const void* known = nullptr;
    thread_local std::vector<std::pair<double, double>> slopes;
    if (known != this) {
        known = this;
        slopes.clear();
        for (int y = 0; y < map.height(); ++y)
            for (int x = 0; x < map.width(); ++x) {
                const double along = map.at((x + 1) % map.width(), y) - map.at(x, y);
                const double below = map.at(x, std::min(y + 1, map.height() - 1)) - map.at(x, y);
                slopes.emplace_back(along, below);
            }
    }
    const auto& [Bu, Bv] = slopes[static_cast<std::size_t>(row * map.width() + column)];

    // Step 4: Equation (2), since Pu x Pv is the normal and both slopes are taken along their
    // tangents. NOTES.md says why the signs differ.
    return (normal + Bu * normal.cross(Pv) - Bv * normal.cross(Pu)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
