#include <grader/decision/distributed/AimAgreement.h>
#include <grader/decision/distributed/Bounds.h>
#include <grader/decision/distributed/Draw.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <iterator>

namespace ticker::decision {
namespace {

// A line may miss the ball by the shadow bias, where the direction was taken from the point itself.
constexpr double kBiasAllowance = 1.5e-3;

/// How far the feet of one point agree, from 0 to 1: in their direction, and in the line that they
/// lie along.
struct Agreement {
    double direction = 0.0;
    double line = 0.0;
};

Agreement agreementOf(const std::vector<AimLine>& lines, const Perpendiculars& sides) {
    double x = 0.0;
    double y = 0.0;
    double cosine = 0.0;  // of twice the angle, so that opposite feet lie along the same line
    double sine = 0.0;
    double squares = 0.0;
    for (const AimLine& line : lines) {
        const double first = line.foot.dot(sides.first);
        const double second = line.foot.dot(sides.second);
        x += first;
        y += second;
        cosine += first * first - second * second;
        sine += 2.0 * first * second;
        squares += first * first + second * second;
    }
    if (!(squares > 0.0)) return {};
    const auto count = static_cast<double>(lines.size());
    return {(x * x + y * y) / (count * squares),
            (cosine * cosine + sine * sine) / (squares * squares)};
}

}  // namespace

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

// Ten independent aims agree by 0.1 in direction and by less than 0.3 in line, in the mean of all
// accepted shapes; stratified ones by less. The mean over points that are independent is higher
// than that by the bound with a chance of at most kStatementRisk (Hoeffding 1963), while aims along
// one line agree by 1 in the one or the other.
bool goTogether(const std::vector<const ShadowLog*>& far, const std::vector<Vector3>& directions) {
    Agreement sum;
    double points = 0.0;
    for (std::size_t i = 0; i < far.size(); ++i)
        for (const PointLog& point : far[i]->points) {
            const std::vector<AimLine> lines = samplesOf(point, far[i]->settings());
            if (lines.size() < 8) continue;
            const Agreement agreement = agreementOf(lines, perpendicularsOf(directions[i]));
            sum.direction += agreement.direction;
            sum.line += agreement.line;
            points += 1.0;
        }
    if (points < 100.0) return false;
    const double bound = std::sqrt(std::log(1.0 / kStatementRisk) / (2.0 * points));
    return sum.direction / points > 0.125 + bound || sum.line / points > 0.4 + bound;
}

// With n lines at independent angles, n |mean of exp(i k angle)|^2 follows the exponential law of
// mean 1, and the sum over three views the Gamma law: above x with a chance of e^-x (1 + x +
// x^2/2). Pairs of opposite lines count half: 42 is exceeded with a chance of 2e-7 for each k. An
// evenly filled disc that keeps its place in the world has 144 in the mean, or more.
bool looksRound(const std::vector<const ShadowLog*>& far, const std::vector<Vector3>& directions,
                std::size_t distinct) {
    constexpr double kMost = 42.0;
    constexpr std::array kFolds{1.0, 2.0, 3.0, 4.0};
    std::array<double, kFolds.size()> uneven{};
    std::size_t lines = 0;
    for (std::size_t i = 0; i < far.size(); ++i) {
        const Perpendiculars sides = perpendicularsOf(directions[i]);
        std::array<std::complex<double>, kFolds.size()> sums{};
        std::size_t count = 0;
        for (const PointLog& point : far[i]->points)
            for (const AimLine& line : samplesOf(point, far[i]->settings())) {
                const double angle =
                    std::atan2(line.foot.dot(sides.second), line.foot.dot(sides.first));
                for (std::size_t k = 0; k < kFolds.size(); ++k)
                    sums[k] += std::polar(1.0, kFolds[k] * angle);
                ++count;
            }
        for (std::size_t k = 0; k < kFolds.size(); ++k)
            uneven[k] += std::norm(sums[k]) / static_cast<double>(std::max<std::size_t>(count, 1));
        lines += count;
    }
    const double share =
        static_cast<double>(distinct) / static_cast<double>(std::max<std::size_t>(lines, 1));
    return *std::max_element(uneven.begin(), uneven.end()) * share <= kMost;
}

}  // namespace ticker::decision
