#include <grader/tasks/lens/LensChecks.h>
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/LensPlots.h>
#include <grader/tasks/support/Bounds.h>
#include <grader/tasks/support/FindingText.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <string>

namespace ticker::tasks {
namespace {

/// The lens points of all pixels.
struct Lens {
    std::vector<Vector3> points;
    std::size_t distinct = 0;  ///< number of points that count as independent
    Vector3 low;
    Vector3 high;

    [[nodiscard]] Vector3 centre() const { return (low + high) * 0.5; }
    /// Half of the wider side.
    [[nodiscard]] double halfWidth() const {
        return 0.5 * std::max(high.x - low.x, high.y - low.y);
    }
};

Lens lensOf(const LensLog& log) {
    Lens lens;
    std::set<std::array<std::int64_t, 2>> keys;
    for (const LensPixel& pixel : log.pixels)
        for (const LensRay& ray : pixel.rays) {
            if (lens.points.empty()) lens.low = lens.high = ray.origin;
            const Vector3& p = ray.origin;
            lens.low = {std::min(lens.low.x, p.x), std::min(lens.low.y, p.y),
                        std::min(lens.low.z, p.z)};
            lens.high = {std::max(lens.high.x, p.x), std::max(lens.high.y, p.y),
                         std::max(lens.high.z, p.z)};
            lens.points.push_back(p);
            keys.insert({std::llround(p.x * 1e9), std::llround(p.y * 1e9)});
        }
    const bool repeated =
        static_cast<double>(keys.size()) < 0.9 * static_cast<double>(lens.points.size());
    lens.distinct = repeated ? keys.size() : lens.points.size();
    return lens;
}

// Confidence bound on how much narrower than the aperture `count` independent points are: the range
// r of uniform points in [0, 1] has P(range <= r) = n r^(n-1) - (n-1) r^n, solved for the risk by
// bisection.
double rangeShortfall(std::size_t count) {
    if (count < 3) return 1.0;
    const auto n = static_cast<double>(count);
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double r = 0.5 * (low + high);
        const double chance = n * std::pow(r, n - 1.0) - (n - 1.0) * std::pow(r, n);
        (chance < kStatementRisk ? low : high) = r;
    }
    return 1.0 - low;
}

double uniformCdf(double value) {
    return std::clamp(0.5 * (value + 1.0), 0.0, 1.0);
}

// Distribution of half the sum of two uniform numbers in [-1, 1].
double triangleCdf(double value) {
    const double v = std::clamp(value, -1.0, 1.0);
    return v < 0.0 ? 0.5 * (v + 1.0) * (v + 1.0) : 1.0 - 0.5 * (1.0 - v) * (1.0 - v);
}

// Test of the corners: a share of 1 - pi/4 of a square's points lies outside of the inscribed disc,
// and none of a disc's. The marginals and the two diagonals test for an uneven density.
struct ShapeVerdict {
    bool square = true;
    double cornerShare = 0.0;
    double gap = 0.0;
};

ShapeVerdict judgeShape(const Lens& lens) {
    ShapeVerdict verdict;
    const Vector3 centre = lens.centre();
    const double half = lens.halfWidth();
    std::array<std::vector<double>, 4> values;
    std::size_t corners = 0;
    for (const Vector3& point : lens.points) {
        const double x = (point.x - centre.x) / half;
        const double y = (point.y - centre.y) / half;
        if (x * x + y * y > 1.0) ++corners;
        values[0].push_back(x);
        values[1].push_back(y);
        values[2].push_back(0.5 * (x + y));
        values[3].push_back(0.5 * (x - y));
    }
    const double share = static_cast<double>(corners) / static_cast<double>(lens.points.size());
    const auto independent =
        static_cast<std::size_t>(std::lround(share * static_cast<double>(lens.distinct)));
    constexpr double kCorners = 1.0 - std::numbers::pi / 4.0;
    const double slack = rangeShortfall(lens.distinct);
    for (std::size_t i = 0; i < values.size(); ++i)
        verdict.gap = std::max(verdict.gap, i < 2 ? largestGap(values[i], uniformCdf)
                                                  : largestGap(values[i], triangleCdf));
    verdict.cornerShare = share;
    const bool cornersMissing =
        share < kCorners && chernoffTail(independent, lens.distinct, kCorners) < kStatementRisk;
    verdict.square = !cornersMissing && verdict.gap <= dkwBound(lens.distinct) + slack;
    return verdict;
}

// The rays of one pixel start on one row or column of the lens, or in one corner. The range of
// fifty independent points is below half of the lens with a chance below 1e-12 (see
// rangeShortfall).
bool usesPartOfLens(const LensLog& log, const Lens& lens) {
    constexpr std::size_t kEnough = 50;
    for (const LensPixel& pixel : log.pixels) {
        if (pixel.rays.size() < kEnough) continue;
        const auto rangeOf = [&](double Vector3::*axis) {
            const auto [low, high] = std::minmax_element(pixel.rays.begin(), pixel.rays.end(),
                                                         [&](const LensRay& a, const LensRay& b) {
                                                             return a.origin.*axis < b.origin.*axis;
                                                         });
            return high->origin.*axis - low->origin.*axis;
        };
        if (rangeOf(&Vector3::x) < 0.5 * (lens.high.x - lens.low.x) ||
            rangeOf(&Vector3::y) < 0.5 * (lens.high.y - lens.low.y))
            return true;
    }
    return false;
}

// All points lie on one straight line. The chance that ten independent points of a square do so,
// within a thousandth of its half-width, is below 1e-20.
bool isLine(const Lens& lens) {
    constexpr std::size_t kEnough = 10;
    constexpr double kWidth = 1e-3;
    if (lens.distinct < kEnough) return false;
    const Vector3 from = lens.points.front();
    const auto farthest = std::ranges::max_element(
        lens.points, {}, [&](const Vector3& point) { return (point - from).magnitude(); });
    const Vector3 along = (*farthest - from).normalised();
    return std::ranges::all_of(lens.points, [&](const Vector3& point) {
        return along.cross(point - from).magnitude() < kWidth * lens.halfWidth();
    });
}

// Half of all points lie within a small part of the range along each axis: the width comes from a
// few outliers.
bool crowdInTheMiddle(const Lens& lens) {
    constexpr double kSmallPart = 0.3;
    const Vector3 centre = lens.centre();
    const auto crowdAlong = [&](double Vector3::*axis) {
        const auto inside =
            std::count_if(lens.points.begin(), lens.points.end(), [&](const Vector3& point) {
                return std::abs(point.*axis - centre.*axis) < kSmallPart * lens.halfWidth();
            });
        return 2 * static_cast<std::size_t>(inside) > lens.points.size();
    };
    return crowdAlong(&Vector3::x) && crowdAlong(&Vector3::y);
}

// Whether the mean of the points is off the eye. The middle of their range is more sensitive for an
// even square, but unreliable for crowded points, whose range depends on outliers. Hoeffding's
// bound for two means of numbers from -half to half.
bool leansAside(const Lens& lens) {
    Vector3 sum;
    for (const Vector3& point : lens.points)
        sum += point;
    const Vector3 mean = sum / static_cast<double>(lens.points.size());
    const double share =
        std::sqrt(2.0 * std::log(4.0 / kStatementRisk) / static_cast<double>(lens.distinct));
    return std::max(std::abs(mean.x), std::abs(mean.y)) > share * lens.halfWidth();
}

// One side is far longer than the other: its number was scaled differently, or not at all.
std::string hintOfSides(double alongX, double alongY) {
    constexpr double kFar = 1.5;
    if (std::max(alongX, alongY) < kFar * std::min(alongX, alongY)) return {};
    return " x and y are both a random number in [-1, 1] times settings().dofAmount: look for one "
           "that is not scaled, or by something else.";
}

// The accepted half-width that the points fill; 0 if none fits.
double acceptedFactor(const Lens& lens, double amount, double shortfall) {
    for (const double factor : {1.0, 0.5}) {
        const double half = factor * amount;
        if (lens.halfWidth() <= half * (1.0 + 1e-5) && lens.halfWidth() >= half * (1.0 - shortfall))
            return factor;
    }
    return 0.0;
}

}  // namespace

ApertureVerdict checkAperture(const LensLog& log) {
    ApertureVerdict verdict;
    const Lens lens = lensOf(log);
    if (lens.points.size() < 3) return verdict;
    const double amount = log.asked->settings.dofAmount;
    const double half = lens.halfWidth();
    const Vector3 centre = lens.centre();
    const double shortfall = rangeShortfall(lens.distinct);
    const ShapeVerdict shape = judgeShape(lens);
    const double depth = std::max(std::abs(lens.low.z), std::abs(lens.high.z));
    const double factor = acceptedFactor(lens, amount, shortfall);
    const double aside = std::max(std::abs(centre.x), std::abs(centre.y));
    if (usesPartOfLens(log, lens) && (shape.square || !crowdInTheMiddle(lens))) {
        verdict.finding = distributedFinding(
            kDofDisc, Severity::fail,
            "The rays of each pixel were expected to start all over the aperture; those of one "
            "pixel start in a part of it, on a line perhaps.");
    } else if (isLine(lens)) {
        verdict.finding = distributedFinding(
            kDofDisc, Severity::fail,
            "The rays were expected to start all over a square; all of them start on one straight "
            "line.");
        verdict.finding->hint +=
            " Draw a number of its own for y: one that is computed from that "
            "of x stays on a line.";
    } else if (aside > 2.0 * shortfall * half + 1e-7 && (shape.square || leansAside(lens))) {
        verdict.finding = distributedFinding(
            kDofOffCentre, Severity::fail,
            fmt::format("An aperture centred on the eye was expected; its centre is at ({:.3f}, "
                        "{:.3f}).",
                        centre.x, centre.y));
    } else if (depth > 1e-6) {
        verdict.finding = distributedFinding(
            kDofDisc, Severity::fail,
            fmt::format("A square in the plane z = 0 was expected; rays start up to {:.3g} in "
                        "front of it or behind it.",
                        depth));
    } else if (!shape.square) {
        verdict.finding = distributedFinding(
            kDofDisc, Severity::fail,
            fmt::format("An evenly filled square was expected; the starting points, up to {:.3g} "
                        "from its centre in x and {:.3g} in y, form another shape ({:.1f} % of "
                        "them outside of the inscribed disc, 21.5 % expected).",
                        0.5 * (lens.high.x - lens.low.x), 0.5 * (lens.high.y - lens.low.y),
                        100.0 * shape.cornerShare));
        verdict.finding->hint += hintOfSides(lens.high.x - lens.low.x, lens.high.y - lens.low.y);
    } else if (factor == 0.0) {
        verdict.finding = distributedFinding(
            kDofApertureSize, Severity::fail,
            fmt::format("A square of half-width {:.3g} (or {:.3g}) was expected; its half-width is "
                        "{:.3g}.",
                        amount, 0.5 * amount, half));
    }
    if (factor != 0.0) verdict.factor = factor;
    if (verdict.finding) {
        verdict.finding->evidence.emplace_back("halfWidth", half);
        verdict.finding->evidence.emplace_back("centre", std::vector<double>{centre.x, centre.y});
        verdict.finding->evidence.emplace_back("shareInCorners", shape.cornerShare);
        verdict.finding->evidence.emplace_back("largestGap", shape.gap);
        verdict.finding->evidence.emplace_back("points", static_cast<double>(lens.points.size()));
        verdict.finding->plots.push_back(plotLens(log));
    }
    return verdict;
}

}  // namespace ticker::tasks
