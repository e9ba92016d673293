#include <grader/tasks/bump/questions/Ramps.h>

#include <grader/tasks/bump/questions/Numbers.h>
#include <questions/BumpQuestions.h>

#include <cmath>
#include <utility>

namespace ticker::tasks::bump {
namespace {

namespace questions = raytracer::questions;
using probe::HeightMapDescription;

/// Rounds to whole bytes, modulo 128, in the brighter half. Tilts of a displaced surface are weaker
/// where it is higher: over half the heights the difference is small.
double inWholeBytes(double height) {
    constexpr long kHalf = 128;
    return kByte * static_cast<double>(kHalf + std::lround(height / kByte) % kHalf);
}

std::vector<double> profile(int count, const RampShape& shape, bool bow) {
    const double rise = shape.slope(count) * (count - 1);
    std::vector<double> heights = bow ? questions::bow(count, rise) : questions::ramp(count, rise);
    for (double& height : heights)
        height = shape.bytesPerTexel == 0 ? shape.base + height : inWholeBytes(height);
    return heights;
}

HeightMapDescription alongU(const RampShape& shape, bool bow) {
    return {shape.columns,
            shape.across,
            {},
            profile(shape.columns, shape, bow),
            questions::level(shape.across)};
}

HeightMapDescription alongV(const RampShape& shape, bool bow) {
    return {shape.across,
            shape.rows,
            {},
            questions::level(shape.across),
            profile(shape.rows, shape, bow)};
}

void addSlopes(Questionnaire& questionnaire, const Ball& ball, RampPlan& plan) {
    plan.uRamp = questionnaire.add(ball, alongU(plan.shape, false), plan.directions);
    plan.uBow = questionnaire.add(ball, alongU(plan.shape, true), plan.directions);
    plan.vRamp = questionnaire.add(ball, alongV(plan.shape, false), plan.directions);
    plan.vBow = questionnaire.add(ball, alongV(plan.shape, true), plan.directions);
}

}  // namespace

RampPlan planRamps(Questionnaire& questionnaire, const Ball& ball, const RampShape& shape,
                   std::vector<Vector3> directions) {
    RampPlan plan;
    plan.shape = shape;
    plan.directions = std::move(directions);
    // As high as the ramps' middle.
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
        seen.push_back({tilt.direction, questions::placeFromTilts(tilt.onURamp, tilt.onUBow),
                        questions::placeFromTilts(tilt.onVRamp, tilt.onVBow)});
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

}  // namespace ticker::tasks::bump
