#include <questions/BumpQuestions.h>

#include <cstddef>
#include <limits>

namespace raytracer::questions {
namespace {

/// The values of `function` at `count` places from 0 to 1 in equal steps.
template <typename Function>
std::vector<double> profile(int count, Function function) {
    std::vector<double> heights;
    heights.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        heights.push_back(function(i / static_cast<double>(count - 1)));
    return heights;
}

}  // namespace

std::vector<double> ramp(int count, double rise) {
    return profile(count, [rise](double x) { return rise * x; });
}

std::vector<double> bow(int count, double rise) {
    return profile(count, [rise](double x) { return rise * x * (1.0 - x); });
}

std::vector<double> level(int count, double height) {
    return std::vector<double>(static_cast<std::size_t>(count), height);
}

double placeFromTilts(const Vector3& onRamp, const Vector3& onBow) {
    const double length = onRamp.dot(onRamp);
    if (!(length > 0.0)) return std::numeric_limits<double>::quiet_NaN();
    return 0.5 * (1.0 - onBow.dot(onRamp) / length);
}

}  // namespace raytracer::questions
