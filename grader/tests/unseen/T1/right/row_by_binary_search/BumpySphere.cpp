#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <unordered_map>
#include <vector>

namespace raytracer {
namespace {

/// The heights y at which one row of a map with `rows` rows gives way to the next, from the top.
/// Depends on nothing but the number of rows, so it may be remembered; one memory for each thread.
const std::vector<double>& rowBorders(int rows) {
    thread_local std::unordered_map<int, std::vector<double>> known;
    auto [place, isNew] = known.try_emplace(rows);
    if (isNew) {
        place->second.reserve(static_cast<std::size_t>(rows));
        for (int k = 1; k < rows; ++k)
            place->second.push_back(std::cos(std::numbers::pi * k / rows));
    }
    return place->second;
}

int rowAt(double y, int rows) {
    const auto& borders = rowBorders(rows);
    const auto found = std::lower_bound(borders.begin(), borders.end(), y, std::greater<>{});
    return static_cast<int>(std::distance(borders.begin(), found));
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = (position - centre()) / radius();
    const HeightMap& map = heightMap();
    const int row = rowAt(n.y, map.height());
    double turn = std::atan2(n.x, -n.z) / (2.0 * std::numbers::pi);
    turn -= std::floor(turn);
    const int column = std::min(static_cast<int>(turn * map.width()), map.width() - 1);

    const double here = map.at(column, row);
    const double along = map.at(column + 1 < map.width() ? column + 1 : 0, row) - here;
    const double below = (row + 1 < map.height() ? map.at(column, row + 1) : here) - here;

    // East from the axis of the globe; at the poles any will do.
    const Vector3 axis{0.0, 1.0, 0.0};
    const Vector3 sideways = n.cross(axis);
    const double length = sideways.magnitude();
    const Vector3 east = length > 1e-12 ? sideways / length : Vector3{1.0, 0.0, 0.0};
    const Vector3 south = n.cross(east);
    return (n - along * east - below * south).normalised();
    // TASK T1 end
}

}  // namespace raytracer
