#include <grader/decision/bump/Ramps.h>

#include <grader/decision/bump/Numbers.h>

#include <cmath>
#include <limits>
#include <utility>

namespace ticker::decision::bump {
namespace {

using probe::HeightMapDescription;

/// The height at x, from 0 to 1 over `count` texels: in proportion to x, or to x (1 - x).
std::vector<double> profile(int count, const RampShape& shape, bool bow) {
    std::vector<double> heights;
    heights.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const double x = i / static_cast<double>(count - 1);
        const double share = bow ? x * (1.0 - x) : x;
        if (shape.bytesPerTexel == 0) {
            heights.push_back(shape.base + shape.rise * share);
        } else {
            const long bytes = std::lround(shape.bytesPerTexel * (count - 1) * share);
            heights.push_back(kByte * static_cast<double>(bytes % 256));
        }
    }
    return heights;
}

std::vector<double> level(int count) {
    return std::vector<double>(static_cast<std::size_t>(count), 0.0);
}

HeightMapDescription alongU(const RampShape& shape, bool bow) {
    return {
        shape.columns, shape.across, {}, profile(shape.columns, shape, bow), level(shape.across)};
}

HeightMapDescription alongV(const RampShape& shape, bool bow) {
    return {shape.across, shape.rows, {}, level(shape.across), profile(shape.rows, shape, bow)};
}

void addSlopes(Questionnaire& questionnaire, const Ball& ball, RampPlan& plan) {
    plan.uRamp = questionnaire.add(ball, alongU(plan.shape, false), plan.directions);
    plan.uBow = questionnaire.add(ball, alongU(plan.shape, true), plan.directions);
    plan.vRamp = questionnaire.add(ball, alongV(plan.shape, false), plan.directions);
    plan.vBow = questionnaire.add(ball, alongV(plan.shape, true), plan.directions);
}

/// Position along a map from the tilts on its ramp and its bow.
double positionFrom(const Vector3& ramp, const Vector3& bow) {
    const double length = ramp.dot(ramp);
    if (!(length > 0.0)) return std::numeric_limits<double>::quiet_NaN();
    return 0.5 * (1.0 - bow.dot(ramp) / length);
}

}  // namespace

RampPlan planRamps(Questionnaire& questionnaire, const Ball& ball, const RampShape& shape,
                   std::vector<Vector3> directions) {
    RampPlan plan;
    plan.shape = shape;
    plan.directions = std::move(directions);
    // As high as the middle of the ramps.
    const double middle = shape.base + 0.5 * shape.rise;
    plan.uFlat =
        questionnaire.add(ball, flatMap(shape.columns, shape.across, middle), plan.directions);
    plan.vFlat =
        questionnaire.add(ball, flatMap(shape.across, shape.rows, middle), plan.directions);
    addSlopes(questionnaire, ball, plan);
    return plan;
}

RampPlan planMoreRamps(Questionnaire& questionnaire, const Ball& ball, const RampPlan& first,
                       double rise) {
    RampPlan plan = first;
    plan.shape.base = 0.0;
    plan.shape.rise = rise;
    addSlopes(questionnaire, ball, plan);
    return plan;
}

std::vector<RampTilts> readRamps(const RampPlan& plan, const Answers& answers) {
    const std::vector<Vector3> uRamp = answers.tiltsBeyond(plan.uFlat, plan.uRamp);
    const std::vector<Vector3> uBow = answers.tiltsBeyond(plan.uFlat, plan.uBow);
    const std::vector<Vector3> vRamp = answers.tiltsBeyond(plan.vFlat, plan.vRamp);
    const std::vector<Vector3> vBow = answers.tiltsBeyond(plan.vFlat, plan.vBow);
    std::vector<RampTilts> tilts;
    tilts.reserve(uRamp.size());
    for (std::size_t i = 0; i < uRamp.size(); ++i)
        tilts.push_back({plan.directions[i], uRamp[i], uBow[i], vRamp[i], vBow[i]});
    return tilts;
}

std::vector<Sighting> sightings(const std::vector<RampTilts>& tilts) {
    std::vector<Sighting> seen;
    seen.reserve(tilts.size());
    for (const RampTilts& tilt : tilts)
        seen.push_back({tilt.direction, positionFrom(tilt.onURamp, tilt.onUBow),
                        positionFrom(tilt.onVRamp, tilt.onVBow)});
    return seen;
}

RampStrength strength(const std::vector<RampTilts>& tilts, double share) {
    std::vector<double> alongU;
    std::vector<double> alongV;
    for (const RampTilts& tilt : tilts) {
        alongU.push_back(tilt.onURamp.magnitude());
        alongV.push_back(tilt.onVRamp.magnitude());
    }
    return {quantile(std::move(alongU), share), quantile(std::move(alongV), share)};
}

}  // namespace ticker::decision::bump
