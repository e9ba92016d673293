#include <grader/tasks/bump/answers/Parametrisation.h>

#include <grader/tasks/bump/questions/Numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

namespace ticker::tasks::bump {
namespace {

constexpr std::size_t kFewestSightings = 50;
// Within this cosine of the axis (10 degrees) a point says little about its longitude.
constexpr double kNearAxis = 0.985;
// Turns from the seam: so near, a finite difference may reach across it, and the tilt shows no map
// coordinate. A little more than three texels of a map with 260 columns.
constexpr double kNearSeam = 0.015;

double fraction(double value) {
    const double rest = value - std::floor(value);
    return rest < 1.0 ? rest : 0.0;
}

/// Solution of a symmetric 3 x 3 system by Cramer's rule; zero if the system is singular.
Vector3 solve(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& right) {
    const double determinant = a.dot(b.cross(c));
    if (std::abs(determinant) < 1e-12) return {};
    return Vector3{right.dot(b.cross(c)), a.dot(right.cross(c)), a.dot(b.cross(right))} /
           determinant;
}

/// Least-squares fit of the axis: the vector whose dot products with the directions are nearest to
/// cos(pi v). Points whose cos(pi v) differs by more than `tolerance` from their dot product with
/// `guess` are left out.
Vector3 fitAxis(const std::vector<Sighting>& sightings, const Vector3& guess, double tolerance) {
    Vector3 xs;
    Vector3 ys;
    Vector3 zs;
    Vector3 right;
    for (const Sighting& sighting : sightings) {
        const double height = std::cos(kPi * sighting.v);
        const Vector3& n = sighting.direction;
        if (!(std::abs(height - n.dot(guess)) <= tolerance)) continue;
        xs += n * n.x;
        ys += n * n.y;
        zs += n * n.z;
        right += n * height;
    }
    return solve(xs, ys, zs, right);
}

/// Fits all points first, then only those near the fit before: points at poles and seams are
/// outliers.
Vector3 fitAxisRobustly(const std::vector<Sighting>& sightings) {
    constexpr double kEverything = 10.0;
    constexpr std::array kTolerances{0.5, 0.2};
    Vector3 axis = fitAxis(sightings, {}, kEverything);
    for (const double tolerance : kTolerances)
        axis = fitAxis(sightings, axis, tolerance);
    return axis;
}

struct Columns {
    double offset = 0.0;
    bool mirrored = false;
};

/// Origin and direction of the columns round an axis, from the mean phase of u against longitude.
Columns fitColumns(const std::vector<Sighting>& sightings, const Parametrisation& round) {
    std::complex<double> forwards;
    std::complex<double> backwards;
    for (const Sighting& sighting : sightings) {
        if (std::isnan(sighting.u)) continue;
        if (std::abs(sighting.direction.dot(round.axis())) > kNearAxis) continue;
        const double longitude = round.longitude(sighting.direction);
        forwards += std::polar(1.0, kTurn * sighting.u - longitude);
        backwards += std::polar(1.0, kTurn * sighting.u + longitude);
    }
    const bool mirrored = std::abs(backwards) > std::abs(forwards);
    return {fraction(std::arg(mirrored ? backwards : forwards) / kTurn), mirrored};
}

ParametrisationFit measure(const std::vector<Sighting>& sightings,
                           const Parametrisation& parametrisation, double axisLength) {
    std::vector<double> uErrors;
    std::vector<double> vErrors;
    double stray = 0.0;
    for (const Sighting& sighting : sightings) {
        if (std::isnan(sighting.u) || std::isnan(sighting.v)) continue;
        if (std::abs(sighting.direction.dot(parametrisation.axis())) > kNearAxis) continue;
        const double u = parametrisation.u(sighting.direction);
        if (turnDistance(u, 0.0) < kNearSeam) continue;
        uErrors.push_back(turnDistance(sighting.u, u));
        vErrors.push_back(std::abs(sighting.v - parametrisation.v(sighting.direction)));
        const bool near = uErrors.back() <= ParametrisationFit::kStray &&
                          vErrors.back() <= ParametrisationFit::kStray;
        if (!near) stray += 1.0;
    }
    const double count = std::max(1.0, static_cast<double>(uErrors.size()));
    return {parametrisation, axisLength, median(uErrors), median(vErrors), stray / count};
}

}  // namespace

double turnDistance(double a, double b) {
    const double apart = fraction(a - b);
    return std::min(apart, 1.0 - apart);
}

Parametrisation::Parametrisation(const Vector3& axis, double uOffset, bool mirrored)
    : axis_(axis), uOffset_(uOffset), mirrored_(mirrored) {
    const Vector3 towardsCamera{0.0, 0.0, -1.0};
    const Vector3 upwards{0.0, 1.0, 0.0};
    const Vector3 start = std::abs(axis.z) < 0.9 ? towardsCamera : upwards;
    meridian_ = (start - axis * start.dot(axis)).normalised();
    right_ = meridian_.cross(axis_);
}

bool Parametrisation::isUpright() const {
    constexpr double kNearlyAll = 0.998;
    return std::abs(axis_.y) > kNearlyAll;
}

double Parametrisation::longitude(const Vector3& direction) const {
    return std::atan2(direction.dot(right_), direction.dot(meridian_));
}

double Parametrisation::u(const Vector3& direction) const {
    const double turns = longitude(direction) / kTurn;
    return fraction(uOffset_ + (mirrored_ ? -turns : turns));
}

double Parametrisation::v(const Vector3& direction) const {
    return std::acos(std::clamp(direction.dot(axis_), -1.0, 1.0)) / kPi;
}

Vector3 Parametrisation::alongU(const Vector3& direction) const {
    const Vector3 right = direction.cross(axis_).normalised();
    return mirrored_ ? -right : right;
}

Vector3 Parametrisation::alongV(const Vector3& direction) const {
    return (direction * direction.dot(axis_) - axis_).normalised();
}

Vector3 Parametrisation::direction(double u, double v) const {
    const double turns = mirrored_ ? uOffset_ - u : u - uOffset_;
    const double longitude = kTurn * turns;
    return axis_ * std::cos(kPi * v) +
           (meridian_ * std::cos(longitude) + right_ * std::sin(longitude)) * std::sin(kPi * v);
}

bool isOrdinary(const Parametrisation& parametrisation, const Vector3& direction) {
    constexpr double kPoleMargin = 0.06;
    constexpr double kSeamMargin = 0.02;
    const double v = parametrisation.v(direction);
    return std::min(v, 1.0 - v) >= kPoleMargin &&
           turnDistance(parametrisation.u(direction), 0.0) >= kSeamMargin;
}

bool ParametrisationFit::good() const {
    constexpr double kAxisTolerance = 0.06;
    constexpr double kMedianTolerance = 0.02;
    constexpr double kStrayShare = 0.03;
    return std::abs(axisLength - 1.0) <= kAxisTolerance && medianUError <= kMedianTolerance &&
           medianVError <= kMedianTolerance && strayShare <= kStrayShare;
}

std::optional<ParametrisationFit> fitParametrisation(const std::vector<Sighting>& sightings) {
    const auto usable = std::count_if(sightings.begin(), sightings.end(), [](const Sighting& s) {
        return !std::isnan(s.u) && !std::isnan(s.v);
    });
    if (static_cast<std::size_t>(usable) < kFewestSightings) return std::nullopt;
    const Vector3 axis = fitAxisRobustly(sightings);
    const double length = axis.magnitude();
    if (!(length > 0.05)) return std::nullopt;
    const Columns columns = fitColumns(sightings, Parametrisation(axis / length, 0.0, false));
    return measure(sightings, Parametrisation(axis / length, columns.offset, columns.mirrored),
                   length);
}

}  // namespace ticker::tasks::bump
