#include <grader/tasks/shadows/answers/AimAgreement.h>
#include <grader/tasks/shadows/answers/AimViewer.h>
#include <grader/tasks/support/Draw.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace ticker::tasks {
namespace {

using Complex = std::complex<double>;

/// A point's feet as complex numbers z, and the viewer's direction in the same plane.
struct Turned {
    Complex feet;    ///< sum of z^2
    Complex viewer;  ///< of length sin^2 of the angle between viewer and light, at twice the angle
};

Turned turnedAt(const PointLog& point, const ShadowLog& log, const Perpendiculars& sides) {
    const auto across = [&](const Vector3& vector) {
        return Complex{vector.dot(sides.first), vector.dot(sides.second)};
    };
    Turned turned;
    for (const AimLine& line : samplesOf(point, log.settings())) {
        const Complex foot = across(line.foot) / log.settings().lightSize;
        turned.feet += foot * foot;
    }
    const Vector3 towards = point.point.viewer - point.point.position;
    const double distance = towards.magnitude();
    if (distance > 0.0) {
        const Complex viewer = across(towards / distance);
        turned.viewer = viewer * viewer;
    }
    return turned;
}

// A right submission stays below it with a chance of 1 - 2 exp(-6.6^2 / 2), which is 1 - 7e-10.
constexpr double kMostSpread = 6.6;

// Mean square of the viewers' distance from their mean. Those of a question are a thousand times
// farther apart; below it, rounding decides.
constexpr double kLeastApart = 1e-4;

}  // namespace

// A disc that faces the viewer is narrower towards the viewer than across, by the square of the
// angle's cosine. What depends on the question alone, such as a pattern that all points share,
// poles or a shape that keeps its place, cancels where the viewers' mean is taken off: their
// directions are drawn anew for each point. The sum of z^2 over a point's lines, seen in any
// direction, has the same chance to be turned the one way as the other, however these lines depend
// on each other, so that the sum over independent points exceeds x standard deviations, taken from
// their own squares, with a chance of at most 2 exp(-x^2 / 2) (Hoeffding's bound for Rademacher
// sums).
double spreadTowardsViewer(const std::vector<const ShadowLog*>& far,
                           const std::vector<Vector3>& directions) {
    double sum = 0.0;
    double squares = 0.0;
    double apart = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < far.size(); ++i) {
        const Perpendiculars sides = perpendicularsOf(directions[i]);
        std::vector<Turned> points;
        Complex mean;
        for (const PointLog& point : far[i]->points) {
            points.push_back(turnedAt(point, *far[i], sides));
            mean += points.back().viewer;
        }
        mean /= static_cast<double>(std::max<std::size_t>(points.size(), 1));
        for (const Turned& point : points) {
            const double along = (point.feet * std::conj(point.viewer - mean)).real();
            sum += along;
            squares += along * along;
            apart += std::norm(point.viewer - mean);
        }
        count += static_cast<double>(points.size());
    }
    return squares > 0.0 && apart > kLeastApart * count ? sum / std::sqrt(squares) : 0.0;
}

bool turnsWithViewer(const std::vector<const ShadowLog*>& far,
                     const std::vector<Vector3>& directions) {
    return std::abs(spreadTowardsViewer(far, directions)) > kMostSpread;
}

}  // namespace ticker::tasks
