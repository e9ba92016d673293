#include <grader/decision/distributed/AimAgreement.h>
#include <grader/decision/distributed/Bounds.h>
#include <grader/decision/distributed/Draw.h>
#include <grader/decision/distributed/ShadowAims.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

namespace ticker::decision {
namespace {

// Points of the lattice that stands for a shape, for each view; measured against one of 65536
// points, its distribution functions are off by less than 0.006.
constexpr int kLattice = 1024;
constexpr double kLatticeError = 0.01;

// A line may miss the ball by the shadow bias, where the direction was taken from the point itself.
constexpr double kBiasAllowance = 1.5e-3;

double radiusOf(AimShape::Radius radius, double u) {
    switch (radius) {
        case AimShape::Radius::filling:
            return std::cbrt(u);
        case AimShape::Radius::outer:
            return 1.0;
        case AimShape::Radius::even:
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

// Numbers that are compared: the length of a foot, and its place along two axes at right angles to
// the view and along their diagonals. Along the view itself feet have no extent but for the light's
// angular size, so that nothing may be read from there.
constexpr std::size_t kNumbers = 5;

/// Feet of lines, in radii of the light: one list of each number, sorted.
class Feet {
public:
    void add(const Vector3& foot, const Perpendiculars& sides) {
        const double first = foot.dot(sides.first);
        const double second = foot.dot(sides.second);
        const std::array<double, kNumbers> numbers{foot.magnitude(), first, second, first + second,
                                                   first - second};
        for (std::size_t i = 0; i < kNumbers; ++i)
            values_[i].push_back(numbers[i]);
    }
    void add(const Feet& other) {
        for (std::size_t i = 0; i < kNumbers; ++i)
            values_[i].insert(values_[i].end(), other.values_[i].begin(), other.values_[i].end());
    }
    void sort() {
        for (std::vector<double>& list : values_)
            std::sort(list.begin(), list.end());
    }
    [[nodiscard]] std::size_t count() const { return values_[0].size(); }
    [[nodiscard]] const std::vector<double>& lengths() const { return values_[0]; }
    [[nodiscard]] double meanLength() const {
        return std::accumulate(lengths().begin(), lengths().end(), 0.0) /
               static_cast<double>(std::max<std::size_t>(count(), 1));
    }
    /// Largest distance of the distribution functions of all numbers, and the sum of all of them.
    struct Gaps {
        double worst = 0.0;
        double sum = 0.0;
    };
    [[nodiscard]] Gaps gapsFrom(const Feet& expected, double size) const {
        Gaps gaps;
        for (std::size_t i = 0; i < kNumbers; ++i) {
            const double gap = largestGap(values_[i], expected.values_[i], size);
            gaps.worst = std::max(gaps.worst, gap);
            gaps.sum += gap;
        }
        return gaps;
    }

private:
    std::array<std::vector<double>, kNumbers> values_;
};

/// The feet as seen from each direction, and all together.
struct Views {
    std::vector<Feet> each;
    Feet all;

    void finish() {
        for (Feet& feet : each) {
            all.add(feet);
            feet.sort();
        }
        all.sort();
    }
};

Views expectedViews(AimShape shape, const std::vector<Vector3>& directions) {
    Views views;
    for (const Vector3& direction : directions) {
        const Perpendiculars sides = perpendicularsOf(direction);
        Feet feet;
        for (int i = 0; i < kLattice; ++i) {
            const Vector3 aim = aimOf(shape, i);
            feet.add(aim - direction * aim.dot(direction), sides);
        }
        views.each.push_back(std::move(feet));
    }
    views.finish();
    return views;
}

/// How far the views lie from expected ones, where the bounds for the whole and for each view hold;
/// else empty.
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

// Aims that come again, out of a small pool or from a generator that is started again for every
// point, are no new samples. The points of one far-light question stand so close together that
// equal aims give equal feet; the chance that 670 independent ones meet by accident is below 1e-4,
// and only a tenth of them meeting would change anything.
std::size_t independentLines(const std::vector<const ShadowLog*>& far, std::size_t lines) {
    std::size_t most = 0;
    bool repeated = false;
    for (const ShadowLog* log : far) {
        std::set<std::array<std::int64_t, 3>> feet;
        std::size_t count = 0;
        for (const PointLog& point : log->points)
            for (const AimLine& line : samplesOf(point, log->settings())) {
                const auto cell = [](double value) { return std::llround(value * 1e5); };
                feet.insert({cell(line.foot.x), cell(line.foot.y), cell(line.foot.z)});
                ++count;
            }
        most = std::max(most, feet.size());
        repeated = repeated || static_cast<double>(feet.size()) < 0.9 * static_cast<double>(count);
    }
    return repeated ? most : lines;
}

// Three means of feet of variance at most 1/3 (those of a surface, seen from the side): Bernstein's
// bound, in radii.
double leanBound(std::size_t distinct) {
    const double share = std::log(6.0 / kStatementRisk) / static_cast<double>(distinct);
    return std::sqrt(3.0) * (std::sqrt(2.0 / 3.0 * share) + 2.0 / 3.0 * share);
}

void compareShapes(const Views& seen, const std::vector<Vector3>& directions, AimVerdict& verdict) {
    const bool repeated = verdict.distinct < verdict.lines;
    double best = std::numeric_limits<double>::infinity();
    double bestScaled = best;
    for (const AimShape shape : kAcceptedAimShapes) {
        const Views expected = expectedViews(shape, directions);
        // Of `distinct` independent lines at least one comes as near to the rim as this.
        const double rim = quantile(expected.all.lengths(),
                                    1.0 - std::min(1.0, 1.2 * missedShare(verdict.distinct)));
        const std::optional<double> fit =
            fitOf(seen, expected, 1.0, 0.0, verdict.distinct, repeated);
        if (fit && verdict.widest >= rim - kLatticeError && *fit < best) {
            best = *fit;
            verdict.shape = shape;
        }
        // Another size of the same shape: the mean says which, and no line passes outside of it.
        const double size = seen.all.meanLength() / expected.all.meanLength();
        const std::optional<double> scaled =
            fitOf(seen, expected, size, 0.02, verdict.distinct, repeated);
        if (scaled && verdict.widest <= 1.05 * size && *scaled < bestScaled) {
            bestScaled = *scaled;
            verdict.scaledShape = shape;
        }
    }
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
        const Vector3 light = log->scene().pointLights[0].position();
        directions.push_back((light - log->scene().planes[0].point).normalised());
        const Perpendiculars sides = perpendicularsOf(directions.back());
        Feet feet;
        for (const PointLog& point : log->points)
            for (const AimLine& line : samplesOf(point, log->settings())) {
                feet.add(line.foot / radius, sides);
                sum += line.foot / radius;
            }
        seen.each.push_back(std::move(feet));
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
    compareShapes(seen, directions, verdict);
    // Eight aims that are drawn once for all points: within a fifth of the radius, as seen from
    // three sides, with a chance of at most 0.2^8 (uniform radius) for code that earns a warning
    // anyway.
    verdict.huddled = verdict.distinct >= 8 && verdict.widest < 0.2;
    verdict.tooNarrow = !verdict.tooWide && !verdict.shape && verdict.widest < 0.97;
    return verdict;
}

// Kronecker points of the plastic number's analogue in three dimensions (M. Roberts 2018).
Vector3 aimOf(AimShape shape, int i) {
    constexpr double g = 1.22074408460575947536;
    double whole = 0.0;
    const double n = i + 1.0;
    return shaped(shape, std::modf(0.5 + n / g, &whole), std::modf(0.5 + n / (g * g), &whole),
                  std::modf(0.5 + n / (g * g * g), &whole));
}

}  // namespace ticker::decision
