#include <grader/tasks/bump/questions/Fineness.h>

#include <grader/tasks/bump/questions/Numbers.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace ticker::tasks::bump {
namespace {

constexpr int kAcross = 64;
constexpr double kRise = 20.0 * kByte;  // for each texel
// In half turns from the pole.
constexpr double kNearPole = 0.05;
constexpr double kBesidePole = 0.12;
constexpr double kMiddle = 0.2;

/// Rises for `kHalf` texels, then falls for as many.
std::vector<double> zigzag(int count) {
    constexpr int kPeriod = 2 * FinenessPlan::kHalf;
    std::vector<double> heights;
    heights.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        heights.push_back(kRise *
                          (FinenessPlan::kHalf - std::abs(i % kPeriod - FinenessPlan::kHalf)));
    return heights;
}

/// Neighbours at the map's edge may be clamped, wrapped or mirrored. A wide difference is 0 on the
/// zigzag except at the seam, where this choice shows: pairs near the seam are not compared.
bool isAwayFromSeam(double u) {
    constexpr double kMargin = 16.0 / FinenessPlan::kColumns;
    return u > kMargin && u < 1.0 - kMargin;
}

/// 1 if the two tilts of every pair are opposite, -1 if they are equal; 1, too, if they are so
/// small that they show nothing.
/// @param counts  Whether the pair that begins at a point is compared.
/// @param along   The tangent at either point along which tilts are measured.
/// @param usual   The tilt on a ramp of this slope.
template <typename Counts, typename Along, typename Usual>
double opposition(const std::vector<Vector3>& pairs, const std::vector<Vector3>& tilts,
                  Counts counts, Along along, Usual usual) {
    double opposite = 0.0;
    double size = 0.0;
    double expected = 0.0;
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
        if (!counts(pairs[i])) continue;
        const double one = tilts[i].dot(along(pairs[i]));
        const double two = tilts[i + 1].dot(along(pairs[i + 1]));
        if (!std::isfinite(one * two)) continue;
        opposite -= one * two;
        size += std::abs(one * two);
        expected += usual(pairs[i]) * usual(pairs[i]);
    }
    constexpr double kHardly = 0.02;  // of the usual tilt
    return size > kHardly * kHardly * expected ? opposite / size : 1.0;
}

}  // namespace

FinenessPlan planFineness(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    constexpr int kPairs = 60;
    constexpr int kPairsNearPoles = 40;
    constexpr double kStepU = 2.0 * kPi * FinenessPlan::kHalf / FinenessPlan::kColumns;
    constexpr double kStepV = kPi * FinenessPlan::kHalf / FinenessPlan::kRows;
    FinenessPlan plan;
    for (int i = 0; i < kPairs; ++i) {
        const double longitude = draws.uniform(0.0, 2.0 * kPi);
        const double polarAngle = draws.uniform(0.25, 0.75) * kPi;
        plan.pairsU.push_back(directionAt(longitude, polarAngle));
        plan.pairsU.push_back(directionAt(longitude + kStepU, polarAngle));
        plan.pairsV.push_back(directionAt(longitude, polarAngle));
        plan.pairsV.push_back(directionAt(longitude, polarAngle + kStepV));
    }
    // Near the poles a table of arc cosines has its widest steps.
    for (int i = 0; i < kPairsNearPoles; ++i) {
        const double longitude = draws.uniform(0.0, 2.0 * kPi);
        const double fromPole = draws.uniform(kNearPole, kBesidePole) * kPi;
        const double polarAngle = i % 2 == 0 ? fromPole : kPi - fromPole - kStepV;
        plan.pairsV.push_back(directionAt(longitude, polarAngle));
        plan.pairsV.push_back(directionAt(longitude, polarAngle + kStepV));
    }
    const std::vector<double> level = raytracer::questions::level(kAcross);
    plan.zigzagU = questionnaire.addPair(
        ball, {FinenessPlan::kColumns, kAcross, {}, zigzag(FinenessPlan::kColumns), level},
        plan.pairsU);
    plan.zigzagV = questionnaire.addPair(
        ball, {kAcross, FinenessPlan::kRows, {}, level, zigzag(FinenessPlan::kRows)}, plan.pairsV);
    return plan;
}

Fineness readFineness(const FinenessPlan& plan, const Answers& answers,
                      const RampJudgement& ramps) {
    const Parametrisation& parametrisation = ramps.fit->parametrisation;
    if (!parametrisation.isUpright()) return {};
    const double timesU = kRise / ramps.shape.slope(ramps.shape.columns);
    const double timesV = kRise / ramps.shape.slope(ramps.shape.rows);
    const AxisResponse& onU = ramps.response->u;
    const AxisResponse& onV = ramps.response->v;
    const auto alongV = [&](bool inTheMiddle) {
        return opposition(
            plan.pairsV, answers.tiltsBeyond(plan.zigzagV.flat, plan.zigzagV.map),
            [&](const Vector3& n) {
                const double v = parametrisation.v(n);
                return (std::min(v, 1.0 - v) > kMiddle) == inTheMiddle;
            },
            [&](const Vector3& n) { return parametrisation.alongV(n); },
            [&](const Vector3& n) { return timesV * strengthAt(onV, parametrisation.v(n)); });
    };
    return {opposition(
                plan.pairsU, answers.tiltsBeyond(plan.zigzagU.flat, plan.zigzagU.map),
                [&](const Vector3& n) { return isAwayFromSeam(parametrisation.u(n)); },
                [&](const Vector3& n) { return parametrisation.alongU(n); },
                [&](const Vector3& n) { return timesU * strengthAt(onU, parametrisation.v(n)); }),
            std::min(alongV(true), alongV(false))};
}

}  // namespace ticker::tasks::bump
