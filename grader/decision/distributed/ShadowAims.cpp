#include <grader/decision/distributed/Bounds.h>
#include <grader/decision/distributed/ShadowAims.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <set>

namespace ticker::decision {
namespace {

// Points of the lattice that stands for a shape, for each view; measured against one of 65536
// points, its distribution functions are off by less than 0.006.
constexpr int kLattice = 1024;
constexpr double kLatticeError = 0.01;

// A line may miss the ball by the shadow bias, where the direction was taken from the point itself.
constexpr double kBiasAllowance = 1.5e-3;

Vector3 shaped(AimShape shape, double u, double v, double w) {
    const double turn = 2.0 * std::numbers::pi * w;
    const double angle = std::numbers::pi * v;
    const double z = shape == AimShape::polarHelper ? std::cos(angle) : 2.0 * v - 1.0;
    const double ring = std::sqrt(std::max(0.0, 1.0 - z * z));
    double radius = u;
    if (shape == AimShape::ball) radius = std::cbrt(u);
    if (shape == AimShape::surface) radius = 1.0;
    return Vector3{ring * std::cos(turn), ring * std::sin(turn), z} * radius;
}

/// Feet of lines, in radii of the light, as the numbers that are compared: the length, then the
/// places along the axes and along the diagonals of the axes.
struct Feet {
    std::array<std::vector<double>, 10> values;

    void add(const Vector3& foot) {
        const std::array<double, 10> numbers{
            foot.magnitude(), foot.x,          foot.y,          foot.z,          foot.x + foot.y,
            foot.x - foot.y,  foot.y + foot.z, foot.y - foot.z, foot.z + foot.x, foot.z - foot.x};
        for (std::size_t i = 0; i < numbers.size(); ++i)
            values[i].push_back(numbers[i]);
    }
    [[nodiscard]] Feet scaled(double factor) const {
        Feet result = *this;
        for (std::vector<double>& list : result.values)
            for (double& value : list)
                value *= factor;
        return result;
    }
    [[nodiscard]] double mean(std::size_t which) const {
        double sum = 0.0;
        for (const double value : values[which])
            sum += value;
        return sum / static_cast<double>(std::max<std::size_t>(values[which].size(), 1));
    }
};

// Kronecker points of the plastic number's analogue in three dimensions (M. Roberts 2018).
Feet expectedFeet(AimShape shape, const std::vector<Vector3>& views) {
    constexpr double g = 1.22074408460575947536;
    Feet feet;
    for (const Vector3& view : views) {
        for (int i = 1; i <= kLattice; ++i) {
            double whole = 0.0;
            const Vector3 aim =
                shaped(shape, std::modf(0.5 + i / g, &whole), std::modf(0.5 + i / (g * g), &whole),
                       std::modf(0.5 + i / (g * g * g), &whole));
            feet.add(aim - view * aim.dot(view));
        }
    }
    return feet;
}

double worstGap(const Feet& seen, const Feet& expected) {
    double gap = 0.0;
    for (std::size_t i = 0; i < seen.values.size(); ++i)
        gap = std::max(gap, largestGap(seen.values[i], expected.values[i]));
    return gap;
}

double quantile(std::vector<double> values, double share) {
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

double shareBeyond(const std::vector<double>& values, double limit) {
    const auto beyond =
        std::count_if(values.begin(), values.end(), [&](double value) { return value > limit; });
    return static_cast<double>(beyond) /
           static_cast<double>(std::max<std::size_t>(values.size(), 1));
}

// An extra ray to the very centre, beside those to random points, is no sample.
std::vector<AimLine> samplesOf(const PointLog& point, const raytracer::RenderSettings& settings) {
    const std::vector<AimLine>& lines = point.lines[0];
    if (lines.size() <= static_cast<std::size_t>(settings.shadowRayCount)) return lines;
    std::vector<AimLine> samples;
    std::copy_if(lines.begin(), lines.end(), std::back_inserter(samples), [&](const AimLine& line) {
        const double bias = (line.origin - point.point.position).magnitude();
        return line.miss > 1e-7 + 1.01 * std::min(bias, kBiasAllowance);
    });
    return samples;
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

}  // namespace

AimVerdict judgeAims(const std::vector<const ShadowLog*>& far) {
    AimVerdict verdict;
    Feet seen;
    std::vector<Vector3> views;
    double radius = 1.0;
    for (const ShadowLog* log : far) {
        radius = log->settings().lightSize;
        const Vector3 light = log->scene().pointLights[0].position();
        views.push_back((light - log->scene().planes[0].point).normalised());
        for (const PointLog& point : log->points)
            for (const AimLine& line : samplesOf(point, log->settings()))
                seen.add(line.foot / radius);
    }
    verdict.lines = seen.values[0].size();
    verdict.distinct = independentLines(far, verdict.lines);
    if (verdict.lines == 0) return verdict;
    verdict.widest = *std::max_element(seen.values[0].begin(), seen.values[0].end());
    verdict.rimShare = shareBeyond(seen.values[0], 0.9 * verdict.widest);
    verdict.lean = Vector3{seen.mean(1), seen.mean(2), seen.mean(3)}.magnitude();
    verdict.tooWide = verdict.widest > 1.0 + 1e-6 + kBiasAllowance / radius;

    // Three means of feet of variance at most 1/3 (those of a surface, seen from the side):
    // Bernstein's bound, in radii.
    const double count = static_cast<double>(verdict.distinct);
    const double logRisk = std::log(6.0 / kStatementRisk);
    const double leanBound =
        std::sqrt(3.0) * (std::sqrt(2.0 / 3.0 * logRisk / count) + 2.0 / 3.0 * logRisk / count);
    verdict.offCentre = verdict.lean > leanBound * std::max(1.0, verdict.widest);

    const double gapBound = dkwBound(verdict.distinct) + kLatticeError;
    double bestGap = 2.0;
    for (const AimShape shape :
         {AimShape::ball, AimShape::surface, AimShape::uniformRadius, AimShape::polarHelper}) {
        const Feet expected = expectedFeet(shape, views);
        // Of `distinct` independent lines at least one comes as near to the rim as this.
        const double rim =
            quantile(expected.values[0], 1.0 - std::min(1.0, 1.2 * missedShare(verdict.distinct)));
        const bool narrow = verdict.widest < rim - kLatticeError;
        const double gap = worstGap(seen, expected);
        if (gap <= gapBound && !narrow && gap < bestGap) {
            bestGap = gap;
            verdict.shape = shape;
        }
        // Another size of the same shape: the mean says which, and no line passes outside of it.
        const double size = seen.mean(0) / expected.mean(0);
        if (!verdict.scaledShape && verdict.widest <= 1.04 * size &&
            worstGap(seen.scaled(1.0 / size), expected) <= gapBound + 0.02)
            verdict.scaledShape = shape;
    }
    verdict.tooNarrow = !verdict.tooWide && !verdict.shape && verdict.widest < 0.97;
    return verdict;
}

std::string_view nameOf(AimShape shape) {
    switch (shape) {
        case AimShape::ball:
            return "uniform in the ball";
        case AimShape::surface:
            return "on the surface of the ball";
        case AimShape::uniformRadius:
            return "uniform in radius and direction";
        case AimShape::polarHelper:
            return "uniform in radius and both angles";
    }
    return "";
}

}  // namespace ticker::decision
