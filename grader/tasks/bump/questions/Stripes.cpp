#include <grader/tasks/bump/questions/Stripes.h>

#include <grader/tasks/bump/questions/Numbers.h>

#include <cmath>

namespace ticker::tasks::bump {
namespace {

std::vector<double> randomStripes(Draws& draws, int count) {
    constexpr int kGreys = 12;  // bytes: gentle enough for every strength
    constexpr int kLowest = 100;
    std::vector<double> heights;
    heights.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        heights.push_back(kByte * (kLowest + draws.integer(0, kGreys)));
    return heights;
}

/// @param along  The tangent across the stripes.
template <typename Along>
double correlation(const std::vector<Vector3>& pairs, const std::vector<Vector3>& tilts,
                   Along along) {
    constexpr double kHardly = 1e-6;  // single precision leaves half of it
    double both = 0.0;
    double ones = 0.0;
    double others = 0.0;
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
        const double one = tilts[i].dot(along(pairs[i]));
        const double other = tilts[i + 1].dot(along(pairs[i + 1]));
        if (!std::isfinite(one * other)) continue;
        both += one * other;
        ones += one * one;
        others += other * other;
    }
    const double size = std::sqrt(ones * others);
    return size > kHardly * kHardly * static_cast<double>(pairs.size()) ? both / size : 1.0;
}

}  // namespace

StripePlan planStripes(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    constexpr int kPairs = 250;
    constexpr int kColumns = 420;
    constexpr int kRows = 230;
    constexpr int kAcross = 64;
    StripePlan plan;
    for (int i = 0; i < kPairs; ++i) {
        const double longitude = draws.uniform(0.0, 2.0 * kPi);
        const double polarAngle = draws.uniform(0.25, 0.75) * kPi;
        const Vector3 point = directionAt(longitude, polarAngle);
        plan.pairsU.push_back(point);
        plan.pairsU.emplace_back(point.x, -point.y, point.z);
        plan.pairsV.push_back(point);
        plan.pairsV.push_back(directionAt(draws.uniform(0.0, 2.0 * kPi), polarAngle));
    }
    const std::vector<double> level = raytracer::questions::level(kAcross);
    plan.columns = questionnaire.addPair(
        ball, {kColumns, kAcross, {}, randomStripes(draws, kColumns), level}, plan.pairsU);
    plan.rows = questionnaire.addPair(
        ball, {kAcross, kRows, {}, level, randomStripes(draws, kRows)}, plan.pairsV);
    return plan;
}

StripeAgreement readStripes(const StripePlan& plan, const Answers& answers,
                            const RampJudgement& ramps) {
    const Parametrisation& parametrisation = ramps.fit->parametrisation;
    if (!parametrisation.isUpright()) return {};
    return {correlation(plan.pairsU, answers.tiltsBeyond(plan.columns.flat, plan.columns.map),
                        [&](const Vector3& n) { return parametrisation.alongU(n); }),
            correlation(plan.pairsV, answers.tiltsBeyond(plan.rows.flat, plan.rows.map),
                        [&](const Vector3& n) { return parametrisation.alongV(n); })};
}

}  // namespace ticker::tasks::bump
