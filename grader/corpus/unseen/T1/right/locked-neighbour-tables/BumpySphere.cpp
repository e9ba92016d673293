// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <shared_mutex>
#include <utility>
#include <vector>

namespace raytracer {

namespace {

/// Which texel is next to which: depends on nothing but the size of the map.
struct Neighbours {
    std::vector<int> left, right, above, below;
    Neighbours(int w, int h) {
        for (int i = 0; i < w; ++i) {
            left.push_back((i + w - 1) % w);
            right.push_back((i + 1) % w);
        }
        for (int j = 0; j < h; ++j) {
            above.push_back(std::max(j - 1, 0));
            below.push_back(std::min(j + 1, h - 1));
        }
    }
};

std::shared_ptr<const Neighbours> neighboursFor(int w, int h) {
    static std::shared_mutex mutex;
    static std::map<std::pair<int, int>, std::shared_ptr<const Neighbours>> known;
    const std::pair key(w, h);
    {
        const std::shared_lock reading(mutex);
        if (const auto found = known.find(key); found != known.end()) return found->second;
    }
    const std::unique_lock writing(mutex);
    auto& slot = known[key];
    if (!slot) slot = std::make_shared<const Neighbours>(w, h);
    return slot;
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = (position - centre()) / radius();
    const double rim = std::sqrt(std::max(0.0, 1.0 - n.y * n.y));
    if (rim < 1e-7) return n.normalised();

    const int w = heightMap().width();
    const int h = heightMap().height();
    const double u = 0.5 + std::atan2(n.x, -n.z) / (2 * std::numbers::pi);
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const auto i = static_cast<std::size_t>(std::clamp(static_cast<int>(u * w), 0, w - 1));
    const auto j = static_cast<std::size_t>(std::clamp(static_cast<int>(v * h), 0, h - 1));
    const int col = static_cast<int>(i);
    const int row = static_cast<int>(j);

    const auto next = neighboursFor(w, h);
    const double bu = heightMap().at(next->right[i], row) - heightMap().at(next->left[i], row);
    const double bv = heightMap().at(col, next->below[j]) - heightMap().at(col, next->above[j]);

    // Equation (2): u to the right, v downwards.
    const Vector3 pu(-n.z / rim, 0, n.x / rim);
    const Vector3 pv = n.cross(pu);
    return (n + bu * n.cross(pv) - bv * n.cross(pu)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
