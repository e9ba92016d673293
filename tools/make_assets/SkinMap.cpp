#include "SkinMap.h"

#include "ExactMath.h"

#include <raytracer/math/Vector3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace assets {
namespace {

using raytracer::Vector3;

constexpr int kMapWidth = 1024;
constexpr int kMapHeight = 512;
constexpr int kScales = 1100;
constexpr std::uint64_t kSeed = 1978;

Vector3 onSphere(double longitudeTurns, double polarTurns) {
    const double ring = sineOfTurns(polarTurns);
    return {ring * sineOfTurns(longitudeTurns), cosineOfTurns(polarTurns),
            -ring * cosineOfTurns(longitudeTurns)};
}

/// Smooth value noise in space, in [0, 1); it varies over about one unit.
double valueNoise(const Vector3& position, std::uint64_t seed) {
    const Vector3 corner{std::floor(position.x), std::floor(position.y), std::floor(position.z)};
    const Vector3 inside = position - corner;
    double sum = 0.0;
    for (unsigned i = 0; i < 8; ++i) {
        const bool right = (i & 1U) != 0;
        const bool up = (i & 2U) != 0;
        const bool far = (i & 4U) != 0;
        const auto key = [](double whole, bool next) {
            return static_cast<std::uint64_t>(static_cast<std::int64_t>(whole) + (next ? 1 : 0));
        };
        const double random = uniform(mixed(
            mixed(mixed(seed ^ key(corner.x, right)) ^ key(corner.y, up)) ^ key(corner.z, far)));
        const auto weight = [](double t, bool next) {
            return next ? smoothStep(0.0, 1.0, t) : 1.0 - smoothStep(0.0, 1.0, t);
        };
        sum += random * weight(inside.x, right) * weight(inside.y, up) * weight(inside.z, far);
    }
    return sum;
}

struct Scale {
    Vector3 middle;
    double height;  // kLowestScale to 1
};

/// Scales distributed over the sphere, and the search for the nearest ones to a point.
class Skin {
public:
    Skin() : spacing_(std::sqrt(4.0 * std::numbers::pi / kScales)) {
        // Fibonacci spiral: evenly distributed, in curved rows like a snake's scales.
        constexpr double kGoldenTurn = 0.6180339887498949;
        for (int i = 0; i < kScales; ++i) {
            const double y = 1.0 - (2.0 * i + 1.0) / kScales;
            const double ring = std::sqrt(1.0 - y * y);
            const double turns = i * kGoldenTurn;
            const Vector3 even{ring * sineOfTurns(turns), y, -ring * cosineOfTurns(turns)};
            scales_.push_back({(even + jitter(i) * (kJitter * spacing_)).normalised(),
                               kLowestScale + (1.0 - kLowestScale) * uniform(keyOf(i, 3))});
        }
        std::ranges::sort(scales_, {}, [](const Scale& scale) { return scale.middle.y; });
    }

    /// In [0, 1]: 0 in the grooves, up to 1 on top of a scale.
    [[nodiscard]] double heightAt(const Vector3& position) const {
        const Vector3 wavy = position + (noiseVector(position) * kWaviness);
        const auto [nearest, distance, second] = nearestTo(wavy.normalised());
        const double groove = smoothStep(0.0, kGrooveWidth * spacing_, second - distance);
        const double fromMiddle = std::min(1.0, distance / (kReach * spacing_));
        const double dome = 1.0 - kRoundness * fromMiddle * fromMiddle;
        return groove * dome * nearest->height;
    }

private:
    static constexpr double kJitter = 0.30;       // of the spacing
    static constexpr double kLowestScale = 0.7;   // height, of the highest
    static constexpr double kWaviness = 0.03;     // radii
    static constexpr double kGrooveWidth = 0.36;  // of the spacing
    static constexpr double kReach = 0.75;        // of the spacing
    static constexpr double kRoundness = 0.6;     // how much lower the rim of a scale is

    struct Nearest {
        const Scale* scale;
        double distance;
        double second;
    };

    static std::uint64_t keyOf(int scale, std::uint64_t what) {
        return mixed(kSeed + static_cast<std::uint64_t>(scale)) + what;
    }

    static Vector3 jitter(int scale) {
        return {2.0 * uniform(keyOf(scale, 0)) - 1.0, 2.0 * uniform(keyOf(scale, 1)) - 1.0,
                2.0 * uniform(keyOf(scale, 2)) - 1.0};
    }

    static Vector3 noiseVector(const Vector3& position) {
        constexpr double kFrequency = 5.0;
        const auto component = [&position](std::uint64_t which) {
            return 2.0 * valueNoise(position * kFrequency, kSeed + which) - 1.0;
        };
        return {component(101), component(102), component(103)};
    }

    [[nodiscard]] Nearest nearestTo(const Vector3& position) const {
        // No point of the sphere is farther than this from its second nearest scale.
        const double reach = 3.0 * spacing_;
        const auto first = std::ranges::lower_bound(
            scales_, position.y - reach, {}, [](const Scale& scale) { return scale.middle.y; });
        Nearest nearest{nullptr, 4.0, 4.0};
        for (auto scale = first; scale != scales_.end() && scale->middle.y < position.y + reach;
             ++scale) {
            const Vector3 apart = scale->middle - position;
            const double squared = apart.dot(apart);
            if (squared < nearest.distance)
                nearest = {&*scale, squared, nearest.distance};
            else
                nearest.second = std::min(nearest.second, squared);
        }
        return {nearest.scale, std::sqrt(nearest.distance), std::sqrt(nearest.second)};
    }

    double spacing_;
    std::vector<Scale> scales_;
};

std::uint8_t byteAt(const Skin& skin, int column, int row) {
    constexpr double kGrainFrequency = 45.0;
    constexpr double kGrain = 0.06;
    constexpr double kMiddle = 0.5;
    const Vector3 position = onSphere((column + 0.5) / kMapWidth, (row + 0.5) / (2.0 * kMapHeight));
    const double grain = kGrain * (valueNoise(position * kGrainFrequency, kSeed) - 0.5);
    const double height = 0.2 + 0.6 * skin.heightAt(position) + grain;
    // 1 up to 70 degrees of latitude, 0 from 85 degrees on.
    const double ring = std::sqrt(position.x * position.x + position.z * position.z);
    const double calm = smoothStep(0.087, 0.342, ring);
    const double faded = kMiddle + calm * (height - kMiddle);
    return static_cast<std::uint8_t>(std::clamp(255.0 * faded + 0.5, 0.0, 255.0));
}

}  // namespace

raytracer::ByteImage makeSkinMap() {
    const Skin skin;
    raytracer::ByteImage map{kMapWidth, kMapHeight, {}};
    map.rgb.reserve(std::size_t{3} * kMapWidth * kMapHeight);
    for (int row = 0; row < kMapHeight; ++row)
        for (int column = 0; column < kMapWidth; ++column)
            map.rgb.insert(map.rgb.end(), 3, byteAt(skin, column, row));
    return map;
}

}  // namespace assets
