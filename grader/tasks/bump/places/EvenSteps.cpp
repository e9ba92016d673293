#include <grader/tasks/bump/places/EvenSteps.h>

#include <grader/tasks/bump/questions/Numbers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ticker::tasks::bump {
namespace {

constexpr int kWhite = 255;
/// Points in each column, at the same places in all of them. If heights are cut to whole grey
/// levels, a difference to u plus a small step is one level or 0, depending on the place. Rounding
/// may decide which at two of the places, but not at all three.
constexpr std::size_t kPlaces = 3;

probe::HeightMapDescription upAndDown() {
    constexpr int kRows = 8;
    probe::HeightMapDescription map{2 * kWhite, kRows, {}, {}, {}};
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < map.width; ++column)
            map.bytes.push_back(static_cast<std::uint8_t>(std::min(column, 2 * kWhite - column)));
    return map;
}

/// Share of slopes that are not those of the columns around.
double shareUneven(const std::vector<double>& slopes) {
    constexpr std::size_t kAround = 12;  // columns on either side
    constexpr double kHardly = 1e-6;     // single precision leaves half of it
    constexpr double kMostOff = 0.3;     // of the slope
    double uneven = 0.0;
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        const auto from = slopes.begin() + static_cast<std::ptrdiff_t>(i - std::min(i, kAround));
        const auto to =
            slopes.begin() + static_cast<std::ptrdiff_t>(std::min(slopes.size(), i + kAround + 1));
        const double usual = median({from, to});
        if (usual > kHardly && std::abs(slopes[i] - usual) > kMostOff * usual) uneven += 1.0;
    }
    return uneven / static_cast<double>(slopes.size());
}

}  // namespace

EvenStepPlan planEvenSteps(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    constexpr int kPoints = 2 * kWhite * static_cast<int>(kPlaces);
    EvenStepPlan plan;
    const double start = draws.uniform(0.0, 1.0);
    for (int i = 0; i < kPoints; ++i)
        plan.directions.push_back(
            directionAt((start + i) * kTurn / kPoints, draws.uniform(0.49, 0.51) * kPi));
    plan.ramp = questionnaire.addPair(ball, upAndDown(), plan.directions);
    return plan;
}

EvenSteps readEvenSteps(const EvenStepPlan& plan, const Answers& answers,
                        const Parametrisation& parametrisation) {
    if (!parametrisation.isUpright()) return {};
    const std::vector<Vector3> tilts = answers.tiltsBeyond(plan.ramp.flat, plan.ramp.map);
    double least = 1.0;
    for (std::size_t place = 0; place < kPlaces; ++place) {
        std::vector<double> slopes;
        for (std::size_t i = place; i < tilts.size(); i += kPlaces)
            slopes.push_back(std::abs(tilts[i].dot(parametrisation.alongU(plan.directions[i]))));
        least = std::min(least, shareUneven(slopes));
    }
    return {least};
}

}  // namespace ticker::tasks::bump
