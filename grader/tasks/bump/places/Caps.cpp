#include <grader/tasks/bump/places/Caps.h>

#include <grader/tasks/bump/questions/Numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace ticker::tasks::bump {
namespace {

constexpr std::array<Vector3, 3> kCapAxes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
constexpr std::array kCapEnds{1.0, -1.0};
struct CapRing {
    double from;  // degrees from the pole
    double to;
};
// Code that builds tangents from a helper vector usually takes another helper near its ends: beyond
// a cosine of 0.995 (within 5.7 degrees), where the inner ring lies, or beyond 0.99, where the
// outer one does.
constexpr std::array<CapRing, 2> kCapRings{{{4.5, 5.5}, {5.7, 8.0}}};
constexpr std::size_t kCapGroups = kCapEnds.size() * kCapRings.size();  // of each axis
constexpr std::size_t kRingPoints = 48;                                 // of a group

/// Adds points that are spread evenly round the ring from a random start, so that tangents that do
/// not turn with the longitude show.
void addCapRing(std::vector<Vector3>& directions, Draws& draws, const Vector3& pole,
                const CapRing& ring) {
    const Vector3 across{pole.y, pole.z, pole.x};
    const Vector3 beside = pole.cross(across);
    const double start = draws.uniform(0.0, kTurn);
    for (std::size_t i = 0; i < kRingPoints; ++i) {
        const double turn = start + kTurn * static_cast<double>(i) / kRingPoints;
        const double angle = draws.uniform(ring.from, ring.to) / kDegrees;
        directions.push_back(pole * std::cos(angle) +
                             (across * std::cos(turn) + beside * std::sin(turn)) * std::sin(angle));
    }
}

/// Heights from black to white, one byte more in each texel: code that rounds heights to bytes sees
/// every step.
std::vector<double> everyByteOnce() {
    constexpr int kBytes = 256;
    std::vector<double> heights;
    for (int i = 0; i < kBytes; ++i)
        heights.push_back(kByte * i);
    return heights;
}

/// Heights that rise by a byte from row to row within 11 degrees of either end and fall in between,
/// so that the tilt shows if code reads a row far from the pole. Differences over a hundredth of
/// the map stay within these 11 degrees.
std::vector<double> risingNearEnds(int rows) {
    constexpr int kEndRows = 16;
    constexpr int kFirst = 224;
    std::vector<double> heights;
    int height = kFirst;
    for (int i = 0; i < rows; ++i) {
        heights.push_back(kByte * height);
        height += std::min(i + 1, rows - 1 - i) < kEndRows ? 1 : -1;
    }
    return heights;
}

/// The axis of space on which the map's poles lie.
std::optional<std::size_t> axisOf(const Parametrisation& parametrisation) {
    constexpr double kAlong = 0.9996;  // 1.6 degrees, which turns tangents by at most 21
    for (std::size_t i = 0; i < kCapAxes.size(); ++i)
        if (std::abs(kCapAxes.at(i).dot(parametrisation.axis())) > kAlong) return i;
    return std::nullopt;
}

/// Smallest share of right tilts among the groups of one axis.
/// @param falls   Unit tangent along which the ramp falls.
/// @param counts  False for points that are left out: their difference may span both ends of the
///                ramp.
template <typename Falls, typename Counts>
double leastShare(const std::vector<Vector3>& directions, const std::vector<Vector3>& tilts,
                  std::size_t axis, Falls falls, Counts counts) {
    constexpr double kCosine = 0.5;  // of 60 degrees
    double least = 1.0;
    for (std::size_t group = axis * kCapGroups; group < (axis + 1) * kCapGroups; ++group) {
        double tilted = 0.0;
        double right = 0.0;
        for (std::size_t i = group * kRingPoints; i < (group + 1) * kRingPoints; ++i) {
            const double length = tilts[i].magnitude();
            if (!(length > kLeastTilt) || !std::isfinite(length) || !counts(directions[i]))
                continue;
            tilted += 1.0;
            if (tilts[i].dot(falls(directions[i])) > kCosine * length) right += 1.0;
        }
        if (tilted >= 0.5 * kRingPoints) least = std::min(least, right / tilted);
    }
    return least;
}

}  // namespace

CapPlan planCaps(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    // So many texels that a chord over three of them does not cross the pole.
    constexpr int kCapAcross = 200;
    CapPlan plan;
    for (const Vector3& axis : kCapAxes)
        for (const double end : kCapEnds)
            for (const CapRing& ring : kCapRings)
                addCapRing(plan.directions, draws, axis * end, ring);
    const std::vector<double> ramp = everyByteOnce();
    const auto length = static_cast<int>(ramp.size());
    const std::vector<double> level = raytracer::questions::level(kCapAcross);
    plan.columns =
        questionnaire.addPair(ball, {length, kCapAcross, {}, ramp, level}, plan.directions);
    plan.rows = questionnaire.addPair(ball, {kCapAcross, length, {}, level, risingNearEnds(length)},
                                      plan.directions);
    return plan;
}

Caps readCaps(const CapPlan& plan, const Answers& answers, const Parametrisation& parametrisation) {
    constexpr double kNearSeam = 0.04;
    const std::optional<std::size_t> axis = axisOf(parametrisation);
    if (!axis) return {};
    const auto isOffSeam = [&](const Vector3& n) {
        return turnDistance(parametrisation.u(n), 0.0) > kNearSeam;
    };
    return {leastShare(
                plan.directions, answers.tiltsBeyond(plan.columns.flat, plan.columns.map), *axis,
                [&](const Vector3& n) { return -parametrisation.alongU(n); }, isOffSeam),
            leastShare(
                plan.directions, answers.tiltsBeyond(plan.rows.flat, plan.rows.map), *axis,
                [&](const Vector3& n) { return -parametrisation.alongV(n); },
                [](const Vector3&) { return true; })};
}

}  // namespace ticker::tasks::bump
