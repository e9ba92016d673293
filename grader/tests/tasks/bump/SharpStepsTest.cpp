// Grey, light grey and white blocks on black.
#include <grader/tasks/bump/questions/SharpSteps.h>
#include <grader/tests/tasks/bump/Asked.h>
#include <grader/tests/tasks/bump/Judging.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>

namespace ticker::tasks::bump {
namespace {

using selftest::Point;

/// The share of points that turn, for code that takes `bent(slope)` for each slope.
double turnedBy(const std::function<double(double)>& bent, std::uint64_t seed = 4,
                const StepHeights& heights = kWhiteSteps) {
    Questionnaire questionnaire;
    Draws draws(seed);
    const SharpStepPlan plan =
        planSharpSteps(questionnaire, draws, {{0.5, -1.0, 20.0}, 12.0}, heights);
    const auto factor = [&](double slope) { return slope == 0.0 ? 1.0 : bent(slope) / slope; };
    const auto function =
        tests::inProportion(tests::kParametrisation, [&](const tests::Place& at, const Point&) {
            return std::pair{factor(at.alongU), factor(at.alongV)};
        });
    return readSharpSteps(plan, tests::answersOf(questionnaire, function)).turned;
}

TEST(ReadSharpSteps, SeesStepsThatWrap) {
    // The slope is half of the step between two texels: 0.4 to 0.5 of the greatest height at white
    // blocks, 0.2 at grey ones.
    constexpr double kSteep = 0.3 * raytracer::kBumpFactor;
    EXPECT_EQ(turnedBy([](double slope) { return std::abs(slope) > kSteep ? -slope : slope; }),
              1.0);
}

// Fixed-point numbers of 30 bits after the point wrap so in 32 bits. Steps above 4, as white on
// black, keep their sign.
TEST(ReadSharpSteps, SeesStepsThatWrapAtTwo) {
    const auto wrapped = [](double slope) { return std::remainder(2.0 * slope, 4.0) / 2.0; };
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
        EXPECT_EQ(turnedBy(wrapped, seed, kLightSteps), 1.0) << seed;
}

TEST(ReadSharpSteps, AcceptsStepsThatKeepTheirSign) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
        for (const StepHeights& heights : {kWhiteSteps, kLightSteps})
            EXPECT_EQ(turnedBy([](double slope) { return slope; }, seed, heights), 0.0);
    EXPECT_EQ(turnedBy([](double slope) { return std::tanh(slope); }), 0.0)
        << "slopes that saturate are another question's matter";
}

}  // namespace
}  // namespace ticker::tasks::bump
