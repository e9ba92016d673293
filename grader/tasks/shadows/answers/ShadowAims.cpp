#include <grader/tasks/shadows/answers/AimAgreement.h>
#include <grader/tasks/shadows/answers/AimDensity.h>
#include <grader/tasks/shadows/answers/AimFeet.h>
#include <grader/tasks/shadows/answers/AimViewer.h>
#include <grader/tasks/shadows/answers/ShadowAims.h>
#include <grader/tasks/support/Bounds.h>
#include <grader/tasks/support/Distinct.h>
#include <grader/tasks/support/Draw.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <mutex>
#include <numbers>
#include <tuple>
#include <utility>

namespace ticker::tasks {
namespace {

// A ball of density 1 / sqrt(1 - r^2) looks like an even disc. Its radius is sin t; the share of
// the ball within it is (t - sin t cos t) 2 / pi = u, solved by Newton's method.
double flatRadius(double u) {
    constexpr int kSteps = 6;
    const double wanted = u * std::numbers::pi / 2.0;
    double t = std::cbrt(1.5 * wanted);
    for (int i = 0; i < kSteps && t > 0.0; ++i) {
        const double sine = std::sin(t);
        t -= (t - sine * std::cos(t) - wanted) / (2.0 * sine * sine);
    }
    return std::sin(std::min(t, std::numbers::pi / 2.0));
}

double radiusOf(AimShape::Radius radius, double u) {
    switch (radius) {
        case AimShape::Radius::filling:
            return std::cbrt(u);
        case AimShape::Radius::outer:
            return 1.0;
        case AimShape::Radius::root:
            return std::sqrt(u);
        case AimShape::Radius::flat:
            return flatRadius(u);
        case AimShape::Radius::uniform:
            break;
    }
    return u;
}

Vector3 shaped(AimShape shape, double u, double v, double w) {
    using Poles = AimShape::Poles;
    const double turn = 2.0 * std::numbers::pi * w;
    const double z = shape.poles == Poles::none ? 2.0 * v - 1.0 : std::cos(std::numbers::pi * v);
    const double ring = std::sqrt(std::max(0.0, 1.0 - z * z));
    const Vector3 place =
        Vector3{ring * std::cos(turn), ring * std::sin(turn), z} * radiusOf(shape.radius, u);
    if (shape.poles == Poles::x) return {place.z, place.x, place.y};
    if (shape.poles == Poles::y) return {place.x, place.z, place.y};
    return place;
}

/// Distance of the views from the expected ones if the bounds hold for each view and for all
/// together; empty otherwise.
std::optional<double> fitOf(const Views& seen, const Views& expected, double size, double slack,
                            std::size_t distinct, bool repeated) {
    const Feet::Gaps all = seen.all.gapsFrom(expected.all, size);
    if (all.worst > dkwBound(distinct) + kLatticeError + slack) return std::nullopt;
    double sum = all.sum;
    for (std::size_t i = 0; i < seen.each.size(); ++i) {
        const std::size_t count = repeated ? distinct : seen.each[i].count();
        const Feet::Gaps gaps = seen.each[i].gapsFrom(expected.each[i], size);
        if (gaps.worst > dkwBound(count) + kLatticeError + slack) return std::nullopt;
        sum += gaps.sum;
    }
    return sum;
}

double quantile(const std::vector<double>& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

double shareBeyond(const std::vector<double>& values, double limit) {
    const auto beyond =
        std::count_if(values.begin(), values.end(), [&](double value) { return value > limit; });
    return static_cast<double>(beyond) /
           static_cast<double>(std::max<std::size_t>(values.size(), 1));
}

// Repeated aims, from a small pool or from a generator that restarts for every point, are no new
// samples. The points of one far-light question stand so close together that equal aims give equal
// feet. Among 670 independent feet the chance that two coincide is below 1e-4, and only a tenth of
// all feet coinciding would change a result.
std::size_t independentLines(const std::vector<const ShadowLog*>& far, std::size_t lines) {
    std::size_t most = 0;
    bool repeated = false;
    for (const ShadowLog* log : far) {
        std::vector<std::array<std::int64_t, 3>> feet;
        for (const PointLog& point : log->points)
            for (const AimLine& line : samplesOf(point, log->settings())) {
                const auto cell = [](double value) { return std::llround(value * 1e5); };
                feet.push_back({cell(line.foot.x), cell(line.foot.y), cell(line.foot.z)});
            }
        const auto count = static_cast<double>(feet.size());
        const std::size_t distinct = numberOfDifferent(std::move(feet));
        most = std::max(most, distinct);
        repeated = repeated || static_cast<double>(distinct) < 0.9 * count;
    }
    return repeated ? most : lines;
}

// Bernstein's bound for the three components of the mean foot, in radii. The variance of a foot is
// at most 1/3 (a surface, seen from the side).
double leanBound(std::size_t distinct) {
    const double share = std::log(6.0 / kStatementRisk) / static_cast<double>(distinct);
    return std::sqrt(3.0) * (std::sqrt(2.0 / 3.0 * share) + 2.0 / 3.0 * share);
}

// Necessary condition: means of numbers from 0 to `widest` differ by at most `widest` times the
// distance of their distribution functions.
bool mayFit(const Views& seen, AimShape shape, const std::vector<Vector3>& directions,
            const AimVerdict& verdict) {
    const double apart = std::abs(seen.all.meanLength() - expectedMeanLength(shape, directions));
    return apart <=
           (dkwBound(verdict.distinct) + 2.0 * kLatticeError) * std::max(1.0, verdict.widest);
}

void findShape(const Views& seen, const std::vector<const ShadowLog*>& far,
               const std::vector<Vector3>& directions, AimVerdict& verdict) {
    const bool repeated = verdict.distinct < verdict.lines;
    double best = std::numeric_limits<double>::infinity();
    for (const AimShape shape : kAcceptedAimShapes) {
        if (!mayFit(seen, shape, directions, verdict)) continue;
        const Views expected = expectedViews(shape, directions);
        // At least one of `distinct` independent lines comes as near to the rim as this.
        const double rim = quantile(expected.all.lengths(),
                                    1.0 - std::min(1.0, 1.2 * missedShare(verdict.distinct)));
        const std::optional<double> fit =
            fitOf(seen, expected, 1.0, 0.0, verdict.distinct, repeated);
        if (!fit || verdict.widest < rim - kLatticeError || *fit >= best) continue;
        if (!turnsAs(far, directions, verdict.distinct, shape)) continue;
        best = *fit;
        verdict.shape = shape;
    }
}

// Finds another size of the same shape: the mean gives the size, and no line may pass outside of
// it.
void findScaledShape(const Views& seen, const std::vector<const ShadowLog*>& far,
                     const std::vector<Vector3>& directions, AimVerdict& verdict) {
    const bool repeated = verdict.distinct < verdict.lines;
    double best = std::numeric_limits<double>::infinity();
    for (const AimShape shape : kAcceptedAimShapes) {
        const Views expected = expectedViews(shape, directions);
        const double size = seen.all.meanLength() / expected.all.meanLength();
        const std::optional<double> fit =
            fitOf(seen, expected, size, 0.02, verdict.distinct, repeated);
        if (!fit || verdict.widest > 1.05 * size || *fit >= best) continue;
        if (!turnsAs(far, directions, verdict.distinct, shape, size)) continue;
        best = *fit;
        verdict.scaledShape = shape;
    }
}

Vector3 wayToLight(const ShadowLog& log) {
    return (log.scene().pointLights[0].position() - log.scene().planes[0].point).normalised();
}

/// The feet of one question, in radii; adds them to `sum`.
Feet feetOf(const ShadowLog& log, const Vector3& direction, Vector3& sum) {
    const Perpendiculars sides = perpendicularsOf(direction);
    Feet feet;
    for (const PointLog& point : log.points)
        for (const AimLine& line : samplesOf(point, log.settings())) {
            const Vector3 foot = line.foot / log.settings().lightSize;
            feet.add(foot, sides);
            sum += foot;
        }
    return feet;
}

}  // namespace

AimVerdict judgeAims(const std::vector<const ShadowLog*>& far) {
    AimVerdict verdict;
    Views seen;
    std::vector<Vector3> directions;
    Vector3 sum;
    double radius = 1.0;
    for (const ShadowLog* log : far) {
        radius = log->settings().lightSize;
        directions.push_back(wayToLight(*log));
        seen.each.push_back(feetOf(*log, directions.back(), sum));
    }
    seen.finish();
    verdict.lines = seen.all.count();
    if (verdict.lines == 0) return verdict;
    verdict.distinct = independentLines(far, verdict.lines);
    verdict.widest = seen.all.lengths().back();
    verdict.rimShare = shareBeyond(seen.all.lengths(), 0.9 * verdict.widest);
    verdict.lean = sum.magnitude() / static_cast<double>(verdict.lines);
    verdict.tooWide = verdict.widest > 1.0 + 1e-6 + kBiasAllowance / radius;
    verdict.offCentre = verdict.lean > leanBound(verdict.distinct) * std::max(1.0, verdict.widest);
    verdict.together = verdict.distinct == verdict.lines && goTogether(far, directions);
    verdict.turnsWithViewer = turnsWithViewer(far, directions);
    findShape(seen, far, directions, verdict);
    // Eight aims drawn once for all points lie within a fifth of the radius, seen from three sides,
    // with a chance of at most 0.2^8 (uniform radius, which only earns a warning).
    verdict.huddled = verdict.distinct >= 8 && verdict.widest < 0.2;
    verdict.between = !verdict.shape && !verdict.tooWide && !verdict.offCentre &&
                      liesBetween(seen, directions, verdict) &&
                      turnsAs(far, directions, verdict.distinct);
    // The feet of a ball a tenth too large look like those of an even disc; its width distinguishes
    // it.
    if (verdict.tooWide || !verdict.shapeIsRight()) findScaledShape(seen, far, directions, verdict);
    verdict.tooNarrow = !verdict.tooWide && !verdict.shapeIsRight() && verdict.widest < 0.97;
    return verdict;
}

// Kronecker sequence of the plastic number's analogue in three dimensions (M. Roberts 2018).
Vector3 aimOf(AimShape shape, int i) {
    constexpr double g = 1.22074408460575947536;
    double whole = 0.0;
    const double n = i + 1.0;
    return shaped(shape, std::modf(0.5 + n / g, &whole), std::modf(0.5 + n / (g * g), &whole),
                  std::modf(0.5 + n / (g * g * g), &whole));
}

const std::vector<Vector3>& aimsOf(AimShape shape, int count) {
    static std::mutex mutex;
    static std::map<std::tuple<AimShape::Radius, AimShape::Poles, int>, std::vector<Vector3>> known;
    const std::lock_guard lock{mutex};
    const auto [found, isNew] = known.try_emplace({shape.radius, shape.poles, count});
    std::vector<Vector3>& aims = found->second;
    if (isNew)
        for (int i = 0; i < count; ++i)
            aims.push_back(aimOf(shape, i));
    return aims;
}

}  // namespace ticker::tasks
