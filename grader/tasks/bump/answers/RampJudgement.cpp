#include <grader/tasks/bump/answers/RampJudgement.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ticker::tasks::bump {
namespace {

std::vector<Sighting> transpose(std::vector<Sighting> seen) {
    for (Sighting& sighting : seen)
        std::swap(sighting.u, sighting.v);
    return seen;
}

/// True if hardly any tilt on the bow opposes the one on the ramp, although half of every bow
/// falls.
bool losesSigns(const std::vector<RampTilts>& tilts, Vector3 RampTilts::*ramp,
                Vector3 RampTilts::*bow) {
    constexpr double kHardlyAny = 0.1;
    double opposite = 0.0;
    double counted = 0.0;
    for (const RampTilts& tilt : tilts) {
        const double product = (tilt.*ramp).dot(tilt.*bow);
        if (std::isnan(product)) continue;
        counted += 1.0;
        if (product < 0.0) opposite += 1.0;
    }
    return counted > 0.0 && opposite < kHardlyAny * counted;
}

bool isPatchy(const AxisResponse& axis) {
    constexpr double kSome = 0.015;
    return axis.shares.dead > kSome && axis.shares.right + axis.shares.dead > 1.0 - kSome;
}

RampKind kindOf(const Response& response) {
    const Sense u = response.u.sense;
    const Sense v = response.v.sense;
    if (response.dependsOnLongitude()) return RampKind::longitudeDependent;
    if (u == Sense::across && v == Sense::across) return RampKind::swapped;
    if (u == Sense::inverted && v == Sense::inverted) return RampKind::inverted;
    if (u == Sense::inverted && v == Sense::right) return RampKind::invertedU;
    if (u == Sense::right && v == Sense::inverted) return RampKind::invertedV;
    if (u == Sense::right && v == Sense::right) return RampKind::right;
    if (isPatchy(response.u) || isPatchy(response.v)) return RampKind::patchy;
    return RampKind::strangeDirection;
}

RampKind kindWithoutParametrisation(const std::vector<RampTilts>& tilts,
                                    const RampJudgement& judgement) {
    if (judgement.transposed) return RampKind::swapped;
    const bool lost = losesSigns(tilts, &RampTilts::onURamp, &RampTilts::onUBow) ||
                      losesSigns(tilts, &RampTilts::onVRamp, &RampTilts::onVBow);
    return lost ? RampKind::signLost : RampKind::strangeParametrisation;
}

}  // namespace

RampJudgement judgeRamps(const RampShape& shape, const std::vector<RampTilts>& tilts) {
    constexpr double kIgnoredShare = 1e-4;
    RampJudgement judgement;
    judgement.shape = shape;
    judgement.strength = strength(tilts);
    // An axis counts as ignored only if hardly any point is tilted.
    constexpr double kHardlyAPoint = 0.95;
    const auto [alongU, alongV] = strength(tilts, kHardlyAPoint);
    const double strongest = std::max(alongU, alongV);
    // Far below double precision's rounding. The comparison is written so that NaN counts as no
    // tilt.
    constexpr double kNothing = 1e-13;
    if (!(strongest > kNothing)) return judgement;
    if (!(alongU > kIgnoredShare * strongest)) judgement.kind = RampKind::slopeUIgnored;
    if (!(alongV > kIgnoredShare * strongest)) judgement.kind = RampKind::slopeVIgnored;
    if (judgement.kind != RampKind::silent) return judgement;

    const std::vector<Sighting> seen = sightings(tilts);
    judgement.fit = fitParametrisation(seen);
    if (!judgement.fit || !judgement.fit->good()) {
        const auto other = fitParametrisation(transpose(seen));
        judgement.transposed = other && other->good();
        judgement.kind = kindWithoutParametrisation(tilts, judgement);
        return judgement;
    }
    judgement.response = measureResponse(tilts, judgement.fit->parametrisation);
    judgement.kind = kindOf(*judgement.response);
    return judgement;
}

}  // namespace ticker::tasks::bump
