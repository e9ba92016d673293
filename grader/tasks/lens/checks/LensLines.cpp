#include <grader/tasks/lens/checks/LensLines.h>

#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/support/FindingOrder.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace ticker::tasks {
namespace {

// Whether the rays of some pixel start on one row or column of the lens, or in one corner. The
// range of fifty independent points is below half of the lens with a chance below 1e-12 (see
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

// The chance that ten independent points of a square lie on one straight line, within a thousandth
// of its half-width, is below 1e-20.
constexpr std::size_t kEnoughForLine = 10;

template <typename Points, typename PointOf = std::identity>
bool areOnLine(const Points& points, double halfWidth, PointOf pointOf = {}) {
    constexpr double kWidth = 1e-3;
    const Vector3 from = std::invoke(pointOf, points.front());
    const auto lengthTo = [&](const Vector3& point) { return (point - from).magnitude(); };
    const Vector3 farthest =
        std::invoke(pointOf, *std::ranges::max_element(points, {}, [&](const auto& point) {
                        return lengthTo(std::invoke(pointOf, point));
                    }));
    if (lengthTo(farthest) < halfWidth) return false;
    const Vector3 along = (farthest - from).normalised();
    return std::ranges::all_of(points, [&](const auto& point) {
        return along.cross(std::invoke(pointOf, point) - from).magnitude() < kWidth * halfWidth;
    });
}

bool isLine(const Lens& lens) {
    return lens.distinct >= kEnoughForLine && areOnLine(lens.points, lens.halfWidth());
}

// Whether the points of some pixels lie on one line each, while those of all pixels fill a square.
// That happens if both coordinates come from one hash with x and y exchanged: they are equal where
// the pixel's x equals its y. One or two degenerate pixels, such as (0, 0) of a hash, are not
// visible and do not count.
bool haveLines(const LensLog& log, const Lens& lens) {
    constexpr std::ptrdiff_t kEnough = 3;
    const auto pixels = std::ranges::count_if(log.pixels, [&](const LensPixel& pixel) {
        return pixel.rays.size() >= kEnoughForLine &&
               areOnLine(pixel.rays, lens.halfWidth(), &LensRay::origin);
    });
    return pixels >= kEnough * log.asked->repetitions;
}

// Whether more than half of all points lie within a small part of the range along each axis, so
// that the width comes from a few outliers.
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

}  // namespace

std::optional<Finding> checkLines(const LensLog& log, const Lens& lens, const ShapeVerdict& shape) {
    if (usesPartOfLens(log, lens) && (shape.square || !crowdInTheMiddle(lens)))
        return distributedFinding(
            kDofDisc, Severity::fail,
            "The rays of each pixel were expected to start all over the aperture; those of one "
            "pixel start in a part of it, on a line perhaps.");
    if (isLine(lens)) {
        Finding finding = distributedFinding(
            kDofDisc, Severity::fail,
            "The rays were expected to start all over a square; all of them start on one straight "
            "line.");
        finding.hint +=
            " Draw a number of its own for y: one that is computed from that "
            "of x stays on a line.";
        return finding;
    }
    if (!haveLines(log, lens)) return std::nullopt;
    Finding finding = distributedFinding(
        kDofDisc, Severity::fail,
        "The rays of each pixel were expected to start all over a square; those of some pixels "
        "start on a straight line.");
    finding.hint +=
        " The numbers for x and y are the same in some pixels, those with equal x and y "
        "perhaps: draw two numbers that do not depend on each other.";
    return finding;
}

}  // namespace ticker::tasks
