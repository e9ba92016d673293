#include <grader/decision/bump/DirectionWords.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace ticker::decision::bump {
namespace {

std::string directionInWords(const AxisResponse& axis) {
    return fmt::format("{} right, {} inverted, {} along the other axis, {} not at all",
                       percent(axis.shares.right), percent(axis.shares.inverted),
                       percent(axis.shares.across), percent(axis.shares.dead));
}

/// ", everywhere 30 degrees off", where every band of an axis agrees on that.
std::string commonTurn(const AxisResponse& axis) {
    constexpr double kAgree = 10.0;
    const auto [least, most] =
        std::minmax_element(axis.bandDirection.begin(), axis.bandDirection.end());
    const double middle = std::abs(0.5 * (*least + *most));
    if (*most - *least > kAgree || middle < kAgree) return {};
    return fmt::format(", everywhere {:.0f} degrees off", middle);
}

/// ", inverted from 50 % to 100 % of the map's height", where the sign changes with the row alone.
std::string invertedRows(const AxisResponse& axis) {
    constexpr double kNear = 30.0;
    std::size_t first = kBands;
    std::size_t last = 0;
    for (std::size_t band = 0; band < kBands; ++band) {
        const double off = std::abs(axis.bandDirection[band]);
        if (off > kNear && off < 180.0 - kNear) return {};
        if (off <= kNear) continue;
        first = std::min(first, band);
        last = band;
    }
    if (first == kBands || (first == 0 && last + 1 == kBands)) return {};
    const auto share = [](std::size_t band) { return static_cast<double>(band) / kBands; };
    return fmt::format(", inverted from {} to {} of the map's height", percent(share(first)),
                       percent(share(last + 1)));
}

}  // namespace

Words directionWords(const Response& response) {
    const AxisResponse& farthest =
        std::abs(response.u.worstDirection) > std::abs(response.v.worstDirection) ? response.u
                                                                                  : response.v;
    const std::string rowsU = invertedRows(response.u);
    const std::string rowsV = invertedRows(response.v);
    const std::string hint =
        rowsU.empty() && rowsV.empty()
            ? ""
            : "A sign changes on the way down: look for a factor that is positive on one half of "
              "the sphere alone (a cosine of the polar angle, a coordinate of the normal). ";
    return {
        fmt::format("The tilt fits no reading of Equation (1). A slope along u tilts the normal: "
                    "{}{}{}. A slope along v: {}{}{}.",
                    directionInWords(response.u), commonTurn(response.u), rowsU,
                    directionInWords(response.v), commonTurn(response.v), rowsV),
        hint + fmt::format("The farthest off is {}. Work out Pu, Pv, Bu and Bv there by hand and "
                           "compare.",
                           placeInWords(farthest.worst)),
        "Option 1: What to do, steps 2 and 3"};
}

Words patchyWords(const Response& response) {
    const AxisResponse& axis =
        response.u.shares.dead > response.v.shares.dead ? response.u : response.v;
    return {
        fmt::format("On an even slope many points are not tilted at all: {} of them along u, {} "
                    "along v. Elsewhere the direction is right.",
                    percent(response.u.shares.dead), percent(response.v.shares.dead)),
        fmt::format("One of them lies {}. A step in u or v that is smaller than a texel often "
                    "reads the same texel twice; a tangent may have no length there.",
                    placeInWords(axis.deadAt)),
        "Option 1: What to do, steps 2 and 3"};
}

}  // namespace ticker::decision::bump
