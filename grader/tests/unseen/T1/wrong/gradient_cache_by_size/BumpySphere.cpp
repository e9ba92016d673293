#include <raytracer/base/Unfinished.h>
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

struct Slope {
    double u;
    double v;
};

/// All slopes of a map, worked out once.
class GradientField {
public:
    explicit GradientField(const HeightMap& b) : width_(b.width()) {
        slopes_.reserve(static_cast<std::size_t>(b.width()) * b.height());
        for (int r = 0; r < b.height(); ++r)
            for (int c = 0; c < b.width(); ++c)
                slopes_.push_back({b.at((c + 1) % b.width(), r) - b.at(c, r),
                                   r + 1 < b.height() ? b.at(c, r + 1) - b.at(c, r) : 0.0});
    }
    [[nodiscard]] Slope at(int c, int r) const { return slopes_[static_cast<std::size_t>(r) * width_ + c]; }

    static const GradientField& of(const HeightMap& b) {
        static std::mutex mutex;
        static std::map<std::pair<int, int>, GradientField> cache;
        const std::lock_guard lock{mutex};
        return cache.try_emplace({b.width(), b.height()}, b).first->second;
    }

private:
    std::size_t width_;
    std::vector<Slope> slopes_;
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z);
    const double lat = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int c = std::min(static_cast<int>((lon / std::numbers::pi + 1.0) / 2.0 * heightMap().width()), heightMap().width() - 1);
    const int r = std::min(static_cast<int>(lat / std::numbers::pi * heightMap().height()), heightMap().height() - 1);
    const Slope b = GradientField::of(heightMap()).at(c, r);
    const Vector3 east{std::cos(lon), 0.0, std::sin(lon)};
    const Vector3 south{std::sin(lon) * n.y, -std::sin(lat), -std::cos(lon) * n.y};
    return (n - b.u * east - b.v * south).normalised();
    // TASK T1 end
}

}  // namespace raytracer
