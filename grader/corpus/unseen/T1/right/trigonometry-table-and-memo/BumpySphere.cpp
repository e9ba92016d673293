#include <raytracer/geometry/BumpySphere.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace raytracer {
namespace {

constexpr int kSteps = 4096;
std::once_flag sineFlag;
std::array<double, kSteps + 1> sines;

// Linear interpolation in a table of one turn.
double tableSin(double angle) {
    std::call_once(sineFlag, [] {
        for (int i = 0; i <= kSteps; ++i)
            sines[static_cast<std::size_t>(i)] = std::sin(2.0 * std::numbers::pi * i / kSteps);
    });
    double turns = angle / (2.0 * std::numbers::pi);
    turns -= std::floor(turns);
    const double at = turns * kSteps;
    const auto low = static_cast<std::size_t>(at) % kSteps;
    return sines[low] + (at - std::floor(at)) * (sines[low + 1] - sines[low]);
}
double tableCos(double angle) { return tableSin(angle + 0.5 * std::numbers::pi); }

struct Slopes {
    double east = 0.0;
    double south = 0.0;
};

// The slopes of every texel that was asked for, for each map.
const Slopes& slopesOf(const HeightMap& map, int column, int row) {
    thread_local std::unordered_map<const HeightMap*, std::unordered_map<std::uint64_t, Slopes>> memo;
    const auto key = static_cast<std::uint64_t>(row) << 32U | static_cast<std::uint64_t>(column);
    const auto [at, fresh] = memo[&map].try_emplace(key);
    if (fresh) {
        const int w = map.width();
        const int up = row == 0 ? 0 : row - 1;
        const int down = row == map.height() - 1 ? row : row + 1;
        at->second.east = map.at((column + 1) % w, row) - map.at((column + w - 1) % w, row);
        at->second.south = map.at(column, down) - map.at(column, up);
    }
    return at->second;
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    double turn = std::atan2(n.z, n.x);  // from the left to the right in front
    if (turn < 0.0) turn += 2.0 * std::numbers::pi;
    const double fall = std::atan2(std::hypot(n.x, n.z), n.y);
    const HeightMap& map = heightMap();
    int column = static_cast<int>(turn / (2.0 * std::numbers::pi) * map.width());
    int row = static_cast<int>(fall / std::numbers::pi * map.height());
    if (column >= map.width()) column = map.width() - 1;
    if (row >= map.height()) row = map.height() - 1;
    const Slopes& slopes = slopesOf(map, column, row);
    const Vector3 onwards{-tableSin(turn), 0.0, tableCos(turn)};
    const Vector3 downwards{tableCos(turn) * tableCos(fall), -tableSin(fall),
                            tableSin(turn) * tableCos(fall)};
    return (n - 0.4 * slopes.east * onwards - 0.4 * slopes.south * downwards).normalised();
}

}  // namespace raytracer
