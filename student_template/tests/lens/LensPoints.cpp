#include <lens/LensPoints.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>

namespace raytracer::tests::lens {

LensPoints::LensPoints(const Trial& trial) {
    std::set<std::array<std::int64_t, 3>> keys;
    for (const std::size_t pixel : {0U, 1U})
        for (const Ray& ray : trial.rays(pixel)) {
            const Vector3& p = ray.origin;
            low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
            points.push_back(p);
            keys.insert(
                {std::llround(p.x * 1e7), std::llround(p.y * 1e7), std::llround(p.z * 1e7)});
        }
    distinct = keys.size();
}

double LensPoints::widest() const {
    return std::max(high.x - low.x, high.y - low.y) / 2.0;
}

double LensPoints::narrowest() const {
    return std::min(high.x - low.x, high.y - low.y) / 2.0;
}

}  // namespace raytracer::tests::lens
