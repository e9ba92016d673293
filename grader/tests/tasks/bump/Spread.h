#ifndef TICKER_TESTS_BUMP_SPREAD_H
#define TICKER_TESTS_BUMP_SPREAD_H

#include <raytracer/math/Vector3.h>

#include <cmath>
#include <vector>

namespace ticker::tests {

/// An even spread of directions.
inline std::vector<raytracer::Vector3> spread(int count) {
    std::vector<raytracer::Vector3> directions;
    for (int i = 0; i < count; ++i) {
        const double y = 1.0 - 2.0 * (i + 0.5) / count;
        const double longitude = 2.4 * i;
        const double ring = std::sqrt(1.0 - y * y);
        directions.emplace_back(ring * std::sin(longitude), y, -ring * std::cos(longitude));
    }
    return directions;
}

}  // namespace ticker::tests

#endif
