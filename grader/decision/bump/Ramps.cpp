#include <grader/decision/bump/Ramps.h>

#include <grader/decision/bump/Numbers.h>
#include <questions/BumpQuestions.h>

#include <utility>

namespace ticker::decision::bump {
namespace {

namespace questions = raytracer::questions;
using probe::HeightMapDescription;

std::vector<double> profile(const RampShape& shape, bool bow) {
    return bow ? questions::bow(shape.along, shape.rise) : questions::ramp(shape.along, shape.rise);
}

HeightMapDescription alongU(const RampShape& shape, bool bow) {
    return {shape.along, shape.across, {}, profile(shape, bow), questions::level(shape.across)};
}

HeightMapDescription alongV(const RampShape& shape, bool bow) {
    return {shape.across, shape.along, {}, questions::level(shape.across), profile(shape, bow)};
}

}  // namespace

RampPlan planRamps(Questionnaire& questionnaire, const Ball& ball, const RampShape& shape,
                   std::vector<Vector3> directions) {
    RampPlan plan;
    plan.shape = shape;
    plan.directions = std::move(directions);
    // As high as the middle of the ramps.
    const double middle = 0.5 * shape.rise;
    plan.uFlat =
        questionnaire.add(ball, flatMap(shape.along, shape.across, middle), plan.directions);
    plan.uRamp = questionnaire.add(ball, alongU(shape, false), plan.directions);
    plan.uBow = questionnaire.add(ball, alongU(shape, true), plan.directions);
    plan.vFlat =
        questionnaire.add(ball, flatMap(shape.across, shape.along, middle), plan.directions);
    plan.vRamp = questionnaire.add(ball, alongV(shape, false), plan.directions);
    plan.vBow = questionnaire.add(ball, alongV(shape, true), plan.directions);
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

RampStrength strength(const std::vector<RampTilts>& tilts) {
    std::vector<double> alongU;
    std::vector<double> alongV;
    for (const RampTilts& tilt : tilts) {
        alongU.push_back(tilt.onURamp.magnitude());
        alongV.push_back(tilt.onVRamp.magnitude());
    }
    return {median(alongU), median(alongV)};
}

}  // namespace ticker::decision::bump
