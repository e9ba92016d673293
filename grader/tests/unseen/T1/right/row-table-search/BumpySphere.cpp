// Rows are found by binary search in a table of cosines instead of by acos: row r is where
// cos(pi r / h) >= n.y > cos(pi (r+1) / h). Tables depend on nothing but the number of rows; every
// thread has its own.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <unordered_map>
#include <vector>

namespace raytracer {
namespace {

const std::vector<double>& lowerEdges(int rows) {
    thread_local std::unordered_map<int, std::vector<double>> tables;
    std::vector<double>& table = tables[rows];
    if (table.empty()) {
        table.resize(static_cast<std::size_t>(rows));
        for (int r = 0; r < rows; ++r)
            table[static_cast<std::size_t>(r)] = std::cos(std::numbers::pi * (r + 1) / rows);
    }
    return table;
}

int rowOf(double y, int rows) {
    const auto& edges = lowerEdges(rows);
    // edges fall from almost 1 to -1: the first that is below y
    const auto it = std::lower_bound(edges.begin(), edges.end(), y, std::greater<>{});
    return std::min(static_cast<int>(it - edges.begin()), rows - 1);
}

int columnOf(const Vector3& n, int columns) {
    // 0 at the back, half-way at the front
    const double turn = (std::atan2(n.x, -n.z) + std::numbers::pi) / (2.0 * std::numbers::pi);
    return static_cast<int>(turn * columns) % columns;
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const HeightMap& m = heightMap();
    const int r = rowOf(n.y, m.height());
    const int c = columnOf(n, m.width());

    const double bu = m.at((c + 1) % m.width(), r) - m.at(c, r);
    const double bv = r == m.height() - 1 ? 0.0 : m.at(c, r + 1) - m.at(c, r);

    const double ring = std::hypot(n.x, n.z);
    const Vector3 right = ring > 0.0 ? Vector3{-n.z / ring, 0.0, n.x / ring} : Vector3{1, 0, 0};
    const Vector3 down = n.cross(right);
    return (n - right * bu - down * bv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
