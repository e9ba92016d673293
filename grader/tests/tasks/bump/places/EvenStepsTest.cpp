// Columns that rise by one grey level each.
#include <grader/tasks/bump/places/EvenSteps.h>
#include <grader/tasks/bump/words/PlaceWords.h>
#include <grader/tests/tasks/bump/Asked.h>
#include <grader/tests/tasks/bump/Judging.h>
#include <grader/tests/tasks/bump/SomeReadings.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace ticker::tasks::bump {
namespace {

using selftest::Point;

double unevenOf(const selftest::NormalFunction& function) {
    Questionnaire questionnaire;
    Draws draws(4);
    const EvenStepPlan plan = planEvenSteps(questionnaire, draws, {{0.5, -1.0, 20.0}, 12.0});
    return readEvenSteps(plan, tests::answersOf(questionnaire, function), tests::kParametrisation)
        .uneven;
}

/// The difference to the next column, of heights that `grey` has changed.
selftest::NormalFunction with(std::function<double(double)> grey) {
    return [grey = std::move(grey)](const Point& point) {
        const Vector3 n = tests::smooth(point);
        const int width = point.map.width();
        const int column =
            std::min(static_cast<int>(tests::kParametrisation.u(n) * width), width - 1);
        const double slope =
            grey(point.map.at((column + 1) % width, 0)) - grey(point.map.at(column, 0));
        return (n - tests::kParametrisation.alongU(n) * slope).normalised();
    };
}

TEST(ReadEvenSteps, SeesGreyLevelsThatAreCut) {
    EXPECT_GT(unevenOf(with([](double height) {
                  return kByte * static_cast<int>(height / raytracer::kBumpFactor * 255);
              })),
              0.1);
}

TEST(ReadEvenSteps, AcceptsGreyLevelsThatAreRounded) {
    EXPECT_EQ(unevenOf(with([](double height) { return kByte * std::round(height / kByte); })),
              0.0);
}

TEST(ReadEvenSteps, AcceptsEveryReadingRoundAnUprightAxis) {
    for (const selftest::Reading& reading : tests::someReadings()) {
        if (reading.top != selftest::Reading::Top::y) continue;
        const auto normals = [&](const Point& point) {
            return modelNormal(reading, selftest::Mistake::none, point);
        };
        EXPECT_LE(unevenOf(normals), 0.03) << describe(reading);
    }
}

TEST(UnevenWords, SayHowManyColumnsAreUnevenAndWhatLosesALevel) {
    const Words words = unevenWords({0.13});
    EXPECT_NE(words.message.find("at 13 % of the columns"), std::string::npos) << words.message;
    EXPECT_NE(words.hint.find("a cast to int makes 30 of it"), std::string::npos) << words.hint;
}

}  // namespace
}  // namespace ticker::tasks::bump
