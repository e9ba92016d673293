// acos is slow: rows are found by binary search in a table of cosines that depends on nothing but the
// number of rows, so it may be kept for good.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>
#include <shared_mutex>
#include <unordered_map>
#include <vector>

namespace raytracer {
namespace {

/// Cosines of the polar angle where one row ends and the next begins, falling.
class RowTable {
public:
    explicit RowTable(int rows) {
        for (int r = 1; r < rows; ++r) ends_.push_back(std::cos(std::numbers::pi * r / rows));
    }
    [[nodiscard]] int rowOf(double y) const {
        return static_cast<int>(
            std::lower_bound(ends_.begin(), ends_.end(), y, std::greater<>{}) - ends_.begin());
    }

private:
    std::vector<double> ends_;
};

const RowTable& tableFor(int rows) {
    static std::shared_mutex mutex;
    static std::unordered_map<int, std::unique_ptr<const RowTable>> tables;
    {
        const std::shared_lock lock{mutex};
        if (const auto it = tables.find(rows); it != tables.end()) return *it->second;
    }
    const std::unique_lock lock{mutex};
    auto& slot = tables[rows];
    if (!slot) slot = std::make_unique<const RowTable>(rows);
    return *slot;
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = (position - centre()) / radius();
    const HeightMap& map = heightMap();
    const int row = tableFor(map.height()).rowOf(n.y);

    const double turns = std::atan2(n.x, -n.z) * (0.5 * std::numbers::inv_pi);  // -1/2 .. 1/2
    int column = static_cast<int>(std::floor(turns * map.width()));
    if (column < 0) column += map.width();
    if (column == map.width()) column = 0;

    const double here = map.at(column, row);
    const double bu = map.at(column == map.width() - 1 ? 0 : column + 1, row) - here;
    const double bv = row == map.height() - 1 ? 0.0 : map.at(column, row + 1) - here;

    // sin and cos of the longitude without trigonometry.
    const double ring = std::sqrt(n.x * n.x + n.z * n.z);
    const double s = ring > 1e-300 ? n.x / ring : 0.0;
    const double c = ring > 1e-300 ? -n.z / ring : 1.0;
    const Vector3 tilted{n.x - bu * c - bv * s * n.y, n.y + bv * ring, n.z - bu * s + bv * c * n.y};
    return tilted.normalised();
    // TASK T1 end
}

}  // namespace raytracer
