#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <utility>
#include <vector>

namespace raytracer {
namespace {
// Both slopes of every texel, worked out the first time a map is seen.
struct Slopes {
    int w = 0, h = 0;
    std::vector<std::pair<double, double>> of;
    explicit Slopes(const HeightMap& m) : w(m.width()), h(m.height()) {
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x)
                of.emplace_back(m.at((x + 1) % w, y) - m.at(x, y),
                                m.at(x, std::min(y + 1, h - 1)) - m.at(x, y));
    }
};

const Slopes& slopesOf(const HeightMap& m) {
    static std::mutex lock;
    static std::map<const HeightMap*, Slopes> known;
    const std::lock_guard guard(lock);
    return known.try_emplace(&m, m).first->second;
}
}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Slopes& s = slopesOf(heightMap());
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z), pol = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int x = std::min(int((lon / std::numbers::pi + 1) / 2 * s.w), s.w - 1);
    const int y = std::min(int(pol / std::numbers::pi * s.h), s.h - 1);
    const auto [du, dv] = s.of[static_cast<std::size_t>(y) * static_cast<std::size_t>(s.w) +
                               static_cast<std::size_t>(x)];
    const Vector3 right{std::cos(lon), 0, std::sin(lon)};
    const Vector3 down = n.cross(right);
    return (n - right * du - down * dv).normalised();
}
}  // namespace raytracer
