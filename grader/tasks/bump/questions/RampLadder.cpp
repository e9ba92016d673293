#include <grader/tasks/bump/questions/RampLadder.h>

#include <grader/tasks/bump/questions/Numbers.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace ticker::tasks::bump {
namespace {

// Gentle ramps are very low beside the sphere's radius: even the exact normal of the displaced
// surface is almost proportional to the slope.
constexpr double kGentleRise = 0.1;
constexpr double kModerateRise = 1.0;
constexpr double kSteepRise = 5.0;

double strongest(const std::vector<RampTilts>& tilts) {
    const RampStrength middle = strength(tilts);
    return std::max(middle.alongU, middle.alongV);
}

/// Compares the steep ramp with the gentle one: whether tilts grow, and whether they keep their
/// direction.
void compareRamps(const std::vector<RampTilts>& gentle, const std::vector<RampTilts>& steep,
                  LadderJudgement& judgement) {
    // Tilts of the exact normal of the displaced surface grow 30 times, proportional tilts 50
    // times, or 5 times from a moderate ramp.
    constexpr double kGrows = 2.0;
    std::vector<double> growth;
    double agreeing = 0.0;
    const RampStrength least = strength(gentle);
    const std::size_t count = std::min(gentle.size(), steep.size());
    for (std::size_t i = 0; i < count; ++i)
        for (const auto& [a, b, usual] :
             {std::tuple(gentle[i].onURamp, steep[i].onURamp, least.alongU),
              std::tuple(gentle[i].onVRamp, steep[i].onVRamp, least.alongV)}) {
            const double product = a.dot(b);
            if (a.magnitude() > 0.1 * usual) growth.push_back(product / a.dot(a));
            if (product >= 0.7 * a.magnitude() * b.magnitude()) agreeing += 1.0;
        }
    judgement.growsWithSlope = median(growth) >= kGrows;
    judgement.steepAgrees = agreeing / (2.0 * static_cast<double>(count));
}

/// Judges the gentle ramps, or moderate ones if rounding shows in the gentle ramps' tilts, or steep
/// ones if rounding shows in both.
void judgeRungs(const RampLadder& ladder, const Answers& answers, LadderJudgement& judgement) {
    // Single precision leaves 1e-7 in a normal, and 1e-5 in the normal of chords over a texel: both
    // are far below the limits.
    constexpr double kClear = 5e-6;
    constexpr double kClearOfChords = 2e-3;
    const std::vector<RampTilts> steep = readRamps(ladder.steep, answers);
    std::vector<RampTilts> low = readRamps(ladder.gentle, answers);
    judgement.ramps = judgeRamps(ladder.gentle.shape, low);
    if (!(strongest(low) > kClearOfChords)) {
        std::vector<RampTilts> moderate = readRamps(ladder.moderate, answers);
        const bool tells = strongest(low) > kClear && judgement.ramps.response;
        const RampJudgement second = judgeRamps(ladder.moderate.shape, moderate);
        // If the axes are exchanged, the exact normal of the displaced surface tilts little on
        // these long maps, whatever their height: only the gentle ramps are then proportional.
        if (second.response || !tells) {
            judgement.ramps = second;
            low = std::move(moderate);
        }
    }
    if (strongest(low) > kClear)
        compareRamps(low, steep, judgement);
    else
        judgement.ramps = judgeRamps(ladder.steep.shape, steep);
}

double sharedShare(std::vector<Vector3> normals) {
    std::erase_if(normals, [](const Vector3& n) { return !isFinite(n); });
    const auto key = [](const Vector3& n) { return std::tuple(n.x, n.y, n.z); };
    std::ranges::sort(normals, {}, key);
    double shared = 0.0;
    for (std::size_t i = 0; i < normals.size(); ++i)
        if ((i > 0 && key(normals[i]) == key(normals[i - 1])) ||
            (i + 1 < normals.size() && key(normals[i]) == key(normals[i + 1])))
            shared += 1.0;
    return shared / std::max(1.0, static_cast<double>(normals.size()));
}

}  // namespace

RampShape drawShape(Draws& draws, double rise) {
    return {draws.integer(2060, 2110), draws.integer(1510, 1590), draws.integer(80, 104), rise};
}

RampLadder planLadder(Questionnaire& questionnaire, Draws& draws, const Ball& ball,
                      const std::vector<Vector3>& directions) {
    RampLadder ladder;
    RampShape shape = drawShape(draws, kGentleRise);
    shape.base = draws.uniform(1.5, 4.2);
    ladder.gentle = planRamps(questionnaire, ball, shape, directions);
    ladder.moderate = planMoreRamps(questionnaire, ball, ladder.gentle, kModerateRise);
    const std::vector<Vector3> half(
        directions.begin(),
        directions.begin() + static_cast<std::ptrdiff_t>(directions.size() / 2));
    ladder.steep = planRamps(questionnaire, ball, drawShape(draws, kSteepRise), half);
    return ladder;
}

LadderJudgement judgeLadder(const RampLadder& ladder, const Answers& answers) {
    LadderJudgement judgement;
    judgeRungs(ladder, answers, judgement);
    judgement.sharedNormals = sharedShare(answers.answer(ladder.gentle.uFlat).normals);
    for (const std::size_t flat :
         {ladder.gentle.uFlat, ladder.gentle.vFlat, ladder.steep.uFlat, ladder.steep.vFlat})
        judgement.flatTilt = std::max(judgement.flatTilt, medianLength(answers.tilts(flat)));
    return judgement;
}

}  // namespace ticker::tasks::bump
