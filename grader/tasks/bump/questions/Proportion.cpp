#include <grader/tasks/bump/questions/Proportion.h>

#include <grader/tasks/bump/questions/Numbers.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ticker::tasks::bump {
namespace {

using probe::HeightMapDescription;

// A hundredth of the map is four texels, so that every difference spans random texels.
constexpr int kWidth = 400;
constexpr int kHeight = 200;
constexpr int kLevels = 5;  // random texels are 0 to 5 levels high

HeightMapDescription scaled(const std::vector<int>& texels, int base, int bytesPerLevel) {
    HeightMapDescription map{kWidth, kHeight, {}, {}, {}};
    map.bytes.reserve(texels.size());
    for (const int level : texels)
        map.bytes.push_back(static_cast<std::uint8_t>(base + level * bytesPerLevel));
    return map;
}

/// Share of the points whose normal makes an angle of 90 degrees or more with the smooth one.
double shareBelow(const std::vector<Vector3>& normals, const std::vector<Vector3>& smooth) {
    double below = 0.0;
    for (std::size_t i = 0; i < smooth.size(); ++i)
        if (normals[i].dot(smooth[i]) <= 0.0) below += 1.0;
    return below / static_cast<double>(smooth.size());
}

/// At least `kLeastTilt`, so that others can be divided by it.
double middleLength(const std::vector<Vector3>& tilts) {
    return std::max(medianLength(tilts), kLeastTilt);
}

/// The mean of values over the mean of their sizes.
class SignedShare {
public:
    void add(double value) {
        if (!std::isfinite(value)) return;
        sum_ += value;
        size_ += std::abs(value);
    }
    [[nodiscard]] double value() const { return size_ > 0.0 ? sum_ / size_ : 0.0; }

private:
    double sum_ = 0.0;
    double size_ = 0.0;
};

}  // namespace

ProportionPlan planProportion(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    constexpr int kPoints = 600;
    ProportionPlan plan;
    plan.directions = draws.directions(kPoints);
    std::vector<int> texels;
    for (int i = 0; i < kWidth * kHeight; ++i)
        texels.push_back(draws.integer(0, kLevels));
    const int lowest = draws.integer(20, 255 - 20 - ProportionPlan::kTimes * kLevels);
    const int middle = lowest + ProportionPlan::kTimes * kLevels / 2;
    plan.flat = questionnaire.add(ball, flatMap(kWidth, kHeight, kByte * middle), plan.directions);
    plan.gentle = questionnaire.add(ball, scaled(texels, middle - kLevels / 2, 1), plan.directions);
    plan.steep =
        questionnaire.add(ball, scaled(texels, lowest, ProportionPlan::kTimes), plan.directions);
    const int dark = draws.integer(0, 2);
    const int bright = draws.integer(235, 245);
    plan.dark = questionnaire.add(ball, scaled(texels, dark, 1), plan.directions);
    plan.bright = questionnaire.add(ball, scaled(texels, bright, 1), plan.directions);
    return plan;
}

Proportion readProportion(const ProportionPlan& plan, const Answers& answers) {
    constexpr double kSomePoints = 0.1;
    Proportion proportion;
    proportion.pastHorizon = shareBelow(answers.answer(plan.steep).normals, plan.directions);
    const std::vector<Vector3> gentle = answers.tiltsBeyond(plan.flat, plan.gentle);
    const double dark = middleLength(answers.tiltsBeyond(plan.flat, plan.dark));
    proportion.brightOverDark = middleLength(answers.tiltsBeyond(plan.flat, plan.bright)) / dark;
    proportion.middleOverDark = middleLength(gentle) / dark;
    const std::vector<Vector3> steep = answers.tiltsBeyond(plan.flat, plan.steep);
    std::vector<double> growth;
    for (std::size_t i = 0; i < gentle.size(); ++i)
        if (gentle[i].magnitude() > kLeastTilt)
            growth.push_back(steep[i].dot(gentle[i]) / gentle[i].dot(gentle[i]));
    if (static_cast<double>(growth.size()) < kSomePoints * static_cast<double>(gentle.size()))
        return proportion;
    proportion.growth = median(growth);
    return proportion;
}

StepBalance readBalance(const ProportionPlan& plan, const Answers& answers,
                        const RampJudgement& ramps) {
    const Parametrisation& parametrisation = ramps.fit->parametrisation;
    const AxisResponse& onU = ramps.response->u;
    const AxisResponse& onV = ramps.response->v;
    const std::vector<Vector3> tilts = answers.tiltsBeyond(plan.flat, plan.gentle);
    if (!(middleLength(tilts) > kLeastTilt)) return {};
    SignedShare alongU;
    SignedShare alongV;
    for (std::size_t i = 0; i < tilts.size(); ++i) {
        const Vector3& n = plan.directions[i];
        if (!isOrdinary(parametrisation, n)) continue;
        // Divided by the code's own strength, which may grow towards the poles, so that all points
        // weigh alike.
        const double v = parametrisation.v(n);
        alongU.add(-onU.sign() * tilts[i].dot(parametrisation.alongU(n)) / strengthAt(onU, v));
        alongV.add(-onV.sign() * tilts[i].dot(parametrisation.alongV(n)) / strengthAt(onV, v));
    }
    return {alongU.value(), alongV.value()};
}

}  // namespace ticker::tasks::bump
