#include <grader/tasks/bump/words/DirectionWords.h>

#include <grader/tasks/bump/questions/Numbers.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

namespace ticker::tasks::bump {
namespace {

std::string directionInWords(const AxisResponse& axis) {
    return fmt::format("{} right, {} inverted, {} along the other axis, {} not at all",
                       percent(axis.shares.right), percent(axis.shares.inverted),
                       percent(axis.shares.across), percent(axis.shares.dead));
}

/// ", everywhere 30 degrees off" if every band of an axis agrees on that; empty otherwise.
std::string commonTurn(const AxisResponse& axis) {
    constexpr double kAgree = 10.0;
    const auto [least, most] =
        std::minmax_element(axis.bandDirection.begin(), axis.bandDirection.end());
    const double middle = std::abs(0.5 * (*least + *most));
    if (*most - *least > kAgree || middle < kAgree) return {};
    return fmt::format(", everywhere {:.0f} degrees off", middle);
}

/// ", inverted from 50 % to 100 % of the map's height" if the sign changes with the row alone.
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

/// ", by 49 degrees at the map's top, -49 at its bottom" if the direction turns with the row.
std::string twist(const AxisResponse& axis) {
    constexpr double kClearly = 40.0;
    const double top = axis.bandDirection.front();
    double turned = 0.0;
    for (std::size_t band = 1; band < kBands; ++band) {
        const double step =
            std::remainder(axis.bandDirection[band] - axis.bandDirection[band - 1], 360.0);
        // The direction turns one way, in small steps: a change of sign is a step of 180.
        if (std::abs(step) > 60.0 || (std::abs(step) > 3.0 && step * turned < 0.0)) return {};
        turned += step;
    }
    if (axis.bandsThatTurn > 0 || std::abs(turned) < kClearly) return {};
    return fmt::format(
        ", turning with the row from {:.0f} degrees aside at the map's top to {:.0f} "
        "at its bottom",
        top, std::remainder(top + turned, 360.0));
}

bool isNear(const AxisResponse& axis, double degrees) {
    constexpr double kNear = 5.0;
    return std::ranges::all_of(axis.bandDirection, [&](double direction) {
        return std::abs(std::abs(direction) - degrees) < kNear;
    });
}

/// True if a slope along the first axis tilts as much along the other, whose own slopes tilt right.
bool tiltsAlongBoth(const AxisResponse& axis, const AxisResponse& other) {
    return isNear(axis, 45.0) && isNear(other, 0.0);
}

Words diagonalWords(const char* axis, const char* other, const char* own, const char* pair) {
    return {
        fmt::format("A slope along {0} tilts the normal 45 degrees aside, along {1} as much as "
                    "along {0}; a slope along {1} is right. So B{1} contains the difference "
                    "along {0}, too.",
                    axis, other),
        fmt::format("B{0} compares texels that lie diagonally: take {1}, both in the point's own "
                    "{2}. Look for a {2} that was moved on for B{3} and is used again. If "
                    "B{0} is right, look at P{3}: it must have no part along P{0}.",
                    other, pair, own, axis),
        "Option 1: What to do, step 3"};
}

/// Whether a slope along the one axis tilts a little along the other one as well, by the same share
/// everywhere, and the other axis is right.
bool leaks(const AxisResponse& axis, const AxisResponse& other) {
    constexpr double kWide = 4.0;
    constexpr double kClearly = 2.0;
    const auto [least, most] = std::ranges::minmax(axis.bandDirection);
    return std::min(axis.shares.right, other.shares.right) > 0.9 && most - least < kWide &&
           isNear(other, 0.0) && std::min(std::abs(least), std::abs(most)) > kClearly;
}

Words leakWords(const AxisResponse& axis, const char* name, const char* other, const char* own) {
    const double share = std::abs(std::tan(axis.bandDirection[kBands / 2] / kDegrees));
    return {
        fmt::format("A slope along {0} alone tilts the normal along {1}, too, by {2} of what it "
                    "tilts along {0}. So B{1} contains a part of the difference along {0}.",
                    name, other, percent(share)),
        fmt::format("B{1} must be 0 where all texels of a {2} are equal. A filter of several "
                    "texels takes those on both sides with the same weights: look for a texel "
                    "with another place than its name says, taken twice or left out. If B{1} "
                    "is right, look at P{1}: it must have no part along P{0}.",
                    name, other, own),
        "Option 1: What to do, step 3"};
}

std::string seenAlong(const AxisResponse& axis) {
    return directionInWords(axis) + commonTurn(axis) + invertedRows(axis) + twist(axis);
}

bool isMostlyRight(const Response& response) {
    return std::min(response.u.shares.right, response.v.shares.right) > 0.7;
}

/// A hint that names the place where the tilt is farthest off. If most points are right, it
/// also says what may be different there.
std::string farthestHint(const Response& response, const Vector3& worst) {
    const std::string place = placeInWords(worst);
    if (!isMostlyRight(response))
        return fmt::format(
            "The farthest off is {}. Work out Pu, Pv, Bu and Bv there by hand and compare.", place);
    constexpr double kNearPoles = 0.7;
    if (std::abs(worst.y) < kNearPoles)
        return fmt::format(
            "Most points are right; the farthest off is {}. Look for a comparison that treats "
            "points there differently, then work out Pu, Pv, Bu and Bv there by hand.",
            place);
    const double row = std::acos(std::min(std::abs(worst.y), 1.0)) / std::numbers::pi;
    return fmt::format(
        "Most points are right; the farthest off is {}, in the rows near a pole, within {} of the "
        "map's height from its edge. First check that u and v are made from the smooth normal, or "
        "from position - centre() in x, y and z alike: a position.x alone is wrong the most near "
        "the poles. Then look for a comparison that builds the tangents from another axis there: "
        "Pu is always the y axis crossed with n, or its opposite, and Pv follows.",
        place, percent(row));
}

/// True for code that is right on a sphere of radius 1 around the origin and nowhere else.
bool isRightAtTheOriginAlone(const std::optional<Hints>& hints) {
    return hints && hints->unitSphere.kind == RampKind::right &&
           hints->square.kind != RampKind::right && hints->asideSphere.kind != RampKind::right;
}

constexpr const char* kCentre =
    "On a sphere of radius 1 around the origin every tilt is right: somewhere the centre is not "
    "subtracted, or the radius not divided out. Make u, v and the tangents from the smooth unit "
    "normal, or from position - centre(), in x, y and z alike: look for a position.x, position.y "
    "or position.z without the centre's.";

/// Where to look first; empty if the directions show no known pattern.
std::string hintOf(const Response& response) {
    if (!invertedRows(response.u).empty() || !invertedRows(response.v).empty())
        return "A sign changes on the way down. Look for a comparison or an abs that turns the "
               "sign of Bu or Bv; if there is none, compare the tangents: with polar angle t and "
               "longitude p, Pv is (sin p cos t, -sin t, -cos p cos t) where rows grow downwards, "
               "so that its y is negative on both halves and cos t changes sign at the equator. "
               "Pu has no polar angle in it. An angle in degrees (180 / pi) changes signs as "
               "well. In a cross product of your own the middle component is a.z * b.x - a.x * "
               "b.z, the other way round than the other two suggest.";
    // With angles in degrees few tilts are right, all over the sphere.
    if (response.tangentsInDegrees && !isMostlyRight(response))
        return "The tangents are those of angles in degrees: std::sin and std::cos take radians, "
               "so leave the factor 180 / pi out of everything that goes into them.";
    const std::string names = twist(response.u).empty()   ? "Pv turns"
                              : twist(response.v).empty() ? "Pu turns"
                                                          : "Pu and Pv turn";
    if (!twist(response.u).empty() || !twist(response.v).empty())
        return names +
               " away with latitude. Pu runs along the circle of latitude, has no y, and does not "
               "depend on the polar angle; Pv runs straight down the meridian: its x and z are "
               "those of n times the cosine over the sine of the polar angle. If both are right, "
               "look at the neighbours: a step along Pu in space leads to another row, too; take "
               "the next column of the same row.";
    return {};
}

/// "below the equator" if all points that are not tilted lie in one half of the sphere.
std::string halfOf(const AxisResponse& axis) {
    constexpr double kBeyond = 0.05;
    constexpr double kWide = 0.5;
    struct Half {
        double from;
        double to;
        const char* low;
        const char* high;
    };
    const Vector3& from = axis.deadFrom;
    const Vector3& to = axis.deadTo;
    for (const Half& half :
         {Half{from.y, to.y, "below the equator", "above the equator"},
          Half{from.x, to.x, "on the left half of the sphere", "on the right half of the sphere"},
          Half{from.z, to.z, "on the half that faces the camera",
               "on the half that the camera does not see"}}) {
        if (half.to - half.from < kWide) continue;
        if (half.to < kBeyond) return half.low;
        if (half.from > -kBeyond) return half.high;
    }
    return {};
}

}  // namespace

Words directionWords(const Response& response, const std::optional<Hints>& hints) {
    if (tiltsAlongBoth(response.u, response.v))
        return diagonalWords("u", "v", "column", "at(column, row) and at(column, row + 1)");
    if (tiltsAlongBoth(response.v, response.u))
        return diagonalWords("v", "u", "row", "at(column, row) and at(column + 1, row)");
    if (leaks(response.u, response.v)) return leakWords(response.u, "u", "v", "column");
    if (leaks(response.v, response.u)) return leakWords(response.v, "v", "u", "row");
    const AxisResponse& farthest =
        std::abs(response.u.worstDirection) > std::abs(response.v.worstDirection) ? response.u
                                                                                  : response.v;
    std::string hint = isRightAtTheOriginAlone(hints) ? kCentre : hintOf(response);
    if (hint.empty()) hint = farthestHint(response, farthest.worst);
    return {fmt::format("The tilt fits no reading of Equation (1). A slope along u tilts the "
                        "normal: {}. A slope along v: {}.",
                        seenAlong(response.u), seenAlong(response.v)),
            hint, "Option 1: What to do, steps 2 and 3"};
}

Words patchyWords(const Response& response) {
    const AxisResponse& axis =
        response.u.shares.dead > response.v.shares.dead ? response.u : response.v;
    const std::string half = halfOf(axis);
    Words words;
    words.message = fmt::format(
        "On an even slope many points are not tilted at all: {} of them along u, {} along v{}. "
        "Elsewhere the direction is right.",
        percent(response.u.shares.dead), percent(response.v.shares.dead),
        half.empty() ? "" : fmt::format(", all of them {}", half));
    words.hint =
        half.empty()
            ? fmt::format(
                  "One of them lies {}. A step in u or v that is smaller than a texel "
                  "often reads the same texel twice; a tangent may have no length there; or a "
                  "comparison leaves out points that face away from the camera.",
                  placeInWords(axis.deadAt))
            : "Look for an if, a max or a clamp that leaves that half out: a comparison "
              "of an angle, "
              "of u or v, or of a coordinate of the normal.";
    words.section = "Option 1: What to do, steps 2 and 3";
    return words;
}

}  // namespace ticker::tasks::bump
