#include <grader/tasks/lens/answers/LensShape.h>

#include <grader/tasks/support/Bounds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <set>

namespace ticker::tasks {
namespace {

double uniformCdf(double value) {
    return std::clamp(0.5 * (value + 1.0), 0.0, 1.0);
}

// Distribution of half the sum of two uniform numbers in [-1, 1].
double triangleCdf(double value) {
    const double v = std::clamp(value, -1.0, 1.0);
    return v < 0.0 ? 0.5 * (v + 1.0) * (v + 1.0) : 1.0 - 0.5 * (1.0 - v) * (1.0 - v);
}

}  // namespace

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

// Random numbers make neither equal steps nor equal counts. A grid of n rays has about sqrt(n)
// places along each side.
Columns columnsOf(const LensLog& log, double Vector3::*axis) {
    constexpr std::size_t kLeast = 3;
    constexpr double kSame = 1e-7;
    if (log.pixels.empty()) return {};
    std::map<std::int64_t, std::size_t> rays;
    for (const LensPixel& pixel : log.pixels)
        for (const LensRay& ray : pixel.rays)
            ++rays[std::llround(ray.origin.*axis * 1e9)];
    const std::size_t count = rays.size();
    if (count < kLeast || count * count > 2 * log.pixels.front().rays.size()) return {};
    const double low = static_cast<double>(rays.begin()->first) * 1e-9;
    const double high = static_cast<double>(rays.rbegin()->first) * 1e-9;
    Columns columns{count, (high - low) / static_cast<double>(count - 1), 0.5 * (low + high)};
    std::size_t at = 0;
    for (const auto& [place, number] : rays)
        if (std::abs(static_cast<double>(place) * 1e-9 - low -
                     static_cast<double>(at++) * columns.step) > kSame)
            return {};
    const auto [fewest, most] =
        std::ranges::minmax_element(rays, {}, [](const auto& cell) { return cell.second; });
    return most->second - fewest->second <= log.pixels.size() ? columns : Columns{};
}

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

}  // namespace ticker::tasks
