#include <grader/tasks/shadows/answers/AimAgreement.h>
#include <grader/tasks/support/Bounds.h>
#include <grader/tasks/support/Draw.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <iterator>
#include <optional>

namespace ticker::tasks {
namespace {

/// Agreement of the feet of one point, from 0 to 1: in direction, and in the line along which they
/// lie.
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

// Sums over feet as complex numbers z: of z, z^2, z^3, z^4, z |z|^2 and |z|^2.
constexpr std::size_t kPowers = 4;
constexpr std::size_t kMoments = kPowers + 2;
using Moments = std::array<std::complex<double>, kMoments>;

void addMoments(const Vector3& foot, const Perpendiculars& sides, Moments& sums) {
    const std::complex<double> z{foot.dot(sides.first), foot.dot(sides.second)};
    std::complex<double> power = z;
    for (std::size_t k = 0; k < kPowers; ++k, power *= z)
        sums[k] += power;
    sums[kPowers] += z * std::norm(z);
    sums.back() += std::norm(z);
}

/// Adds the moments of a line to `sums`, and their squares to `apart`: sums of independent lines
/// have these squares on average.
void addLine(const Vector3& foot, const Perpendiculars& sides, Moments& sums,
             std::array<double, kMoments>& apart) {
    Moments line{};
    addMoments(foot, sides, line);
    for (std::size_t k = 0; k < kMoments; ++k) {
        sums[k] += line[k];
        apart[k] += std::norm(line[k]);
    }
}

Moments expectedMoments(AimShape shape, const Perpendiculars& sides) {
    constexpr int kLattice = 4096;
    Moments means{};
    for (const Vector3& aim : aimsOf(shape, kLattice))
        addMoments(aim, sides, means);
    for (std::complex<double>& mean : means)
        mean /= kLattice;
    return means;
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

// For every accepted shape, ten independent aims agree on average by 0.1 in direction and by less
// than 0.3 in line; stratified aims by less. The mean over independent points exceeds that by the
// bound with a chance of at most kStatementRisk (Hoeffding 1963). Aims along one line have an
// agreement of 1 in one of the two.
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

// Limits of the sums below, in the order of Moments.
constexpr std::array<double, kMoments> kMostUneven{42.0, 42.0, 42.0, 42.0, 50.0, 42.0};

// Lines in opposite pairs cancel except for the perspective, and for a shape with poles that
// remainder adds up over the points. So each point counts with at least this share of the square
// that independent lines have.
constexpr double kLeastSquare = 1e-3;

// Take the sum of z^k over a point's lines, less its expectation. For a right shape it is as likely
// to point one way as the opposite way, however the point's own lines depend on each other. So over
// independent points, exp(t |sum|^2 / sum of squares) has a mean of at most (1 - 2 t)^-1/2
// (Rademacher sums; less if all directions are equally likely). With three views, 42 is exceeded
// with a chance of at most (42 / 3)^1.5 e^-19.5 = 1.8e-7 for each k.
// An evenly filled disc that keeps its place in the world has 90 or more on average, and so has a
// square or an ellipse of 2 : 3 that faces the point. A shape with poles may look like such an
// ellipse except for its size, which |z|^2 measures. A shape without poles looks the same from all
// sides, whatever its density.
// A shape that leans to one side where it is wide and to the other where it is narrow keeps the
// mean of z near 0, but not that of z |z|^2. Code that uses one random number for both radius and
// height has 67 to 109 there (2000 simulated submissions), and the ball at most 15 (6000). The
// limit of 50 is exceeded with a chance of at most (50 / 3)^1.5 e^-23.5 = 4.2e-9.
bool turnsAs(const std::vector<const ShadowLog*>& far, const std::vector<Vector3>& directions,
             std::size_t distinct, std::optional<AimShape> shape, double size) {
    const bool poles = shape && shape->poles != AimShape::Poles::none;
    const std::size_t moments = poles ? kMoments : kMoments - 1;
    std::array<double, kMoments> uneven{};
    std::size_t lines = 0;
    for (std::size_t i = 0; i < far.size(); ++i) {
        const Perpendiculars sides = perpendicularsOf(directions[i]);
        const double radius = far[i]->settings().lightSize * size;
        const Moments expected = poles ? expectedMoments(*shape, sides) : Moments{};
        Moments sums{};
        std::array<double, kMoments> squares{};
        for (const PointLog& point : far[i]->points) {
            const std::vector<AimLine> samples = samplesOf(point, far[i]->settings());
            Moments here{};
            std::array<double, kMoments> apart{};
            for (const AimLine& line : samples)
                addLine(line.foot / radius, sides, here, apart);
            for (std::size_t k = 0; k < moments; ++k) {
                here[k] -= expected[k] * static_cast<double>(samples.size());
                sums[k] += here[k];
                squares[k] += std::max(std::norm(here[k]), kLeastSquare * apart[k]);
            }
            lines += samples.size();
        }
        for (std::size_t k = 0; k < moments; ++k)
            if (squares[k] > 0.0) uneven[k] += std::norm(sums[k]) / squares[k];
    }
    const double share =
        static_cast<double>(distinct) / static_cast<double>(std::max<std::size_t>(lines, 1));
    return std::equal(uneven.begin(), uneven.end(), kMostUneven.begin(),
                      [&](double sum, double most) { return sum * share <= most; });
}

}  // namespace ticker::tasks
