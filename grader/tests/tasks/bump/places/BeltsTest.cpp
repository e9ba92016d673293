// Places where one coordinate is nearly 0.
#include <grader/tasks/bump/Examination.h>
#include <grader/tasks/bump/places/Belts.h>
#include <grader/tasks/bump/words/PlaceWords.h>
#include <grader/tests/tasks/bump/Asked.h>
#include <grader/tests/tasks/bump/Judging.h>
#include <grader/tests/tasks/bump/SomeReadings.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

namespace ticker::tasks::bump {
namespace {

using selftest::Point;

Belts beltsOf(const selftest::NormalFunction& function, std::uint64_t seed,
              const Parametrisation& parametrisation = tests::kParametrisation) {
    Questionnaire questionnaire;
    Draws draws(seed);
    const BeltPlan plan = planBelts(questionnaire, draws, {{0.5, -1.0, 20.0}, 12.0});
    return readBelts(plan, tests::answersOf(questionnaire, function), parametrisation, {});
}

/// Where the map is read, for a point at (u, v) whose smooth normal is n.
using Place = std::function<std::pair<double, double>(const Vector3& n, double u, double v)>;

selftest::NormalFunction readAt(Place place) {
    return [place = std::move(place)](const Point& point) {
        const Parametrisation& at = tests::kParametrisation;
        const Vector3 n = tests::smooth(point);
        const auto [u, v] = place(n, at.u(n), at.v(n));
        const int width = point.map.width();
        const int height = point.map.height();
        const int column = std::min(static_cast<int>(u * width), width - 1);
        const int row = std::min(static_cast<int>(v * height), height - 1);
        const double here = point.map.at(column, row);
        const double toRight = point.map.at((column + 1) % width, row) - here;
        const double toBelow = point.map.at(column, std::min(row + 1, height - 1)) - here;
        return (n - at.alongU(n) * toRight - at.alongV(n) * toBelow).normalised();
    };
}

constexpr double kNearly = 0.02;

TEST(ReadBelts, SeesAnotherColumnWhereACoordinateIsNearlyZero) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 10U, 11U, 12U})
        for (const double instead : {0.0, 0.25, 0.75}) {
            const Belts x = beltsOf(readAt([&](const Vector3& n, double u, double v) {
                                        return std::pair{std::abs(n.x) < kNearly ? instead : u, v};
                                    }),
                                    seed);
            EXPECT_FALSE(x.good()) << seed << " " << instead << " " << x.wrong;
            EXPECT_EQ(x.plane, 'x');
            const Belts z = beltsOf(readAt([&](const Vector3& n, double u, double v) {
                                        return std::pair{std::abs(n.z) < kNearly ? instead : u, v};
                                    }),
                                    seed);
            EXPECT_FALSE(z.good()) << seed << " " << instead << " " << z.wrong;
            EXPECT_EQ(z.plane, 'z');
        }
}

TEST(ReadBelts, SeesAnotherRowAtTheEquator) {
    const Belts belts = beltsOf(readAt([](const Vector3& n, double u, double v) {
                                    return std::pair{u, std::abs(n.y) < kNearly ? 0.0 : v};
                                }),
                                1);
    EXPECT_FALSE(belts.good()) << belts.wrong;
    EXPECT_EQ(belts.plane, 'y');
}

TEST(ReadBelts, SeesNormalsThatStaySmoothThere) {
    const Belts belts = beltsOf(
        [](const Point& point) {
            const Vector3 n = tests::smooth(point);
            const auto same = [](const Vector3&, double u, double v) { return std::pair{u, v}; };
            return std::abs(n.z) < kNearly ? n : readAt(same)(point);
        },
        1);
    EXPECT_FALSE(belts.good()) << belts.wrong;
}

TEST(ReadBelts, LetsEveryAcceptedReadingPass) {
    const MainPlan plan = planMain(3);
    for (const selftest::Reading& reading : tests::someReadings()) {
        const Examination examination =
            examine(plan, tests::answersOf(plan.questionnaire, [&](const Point& point) {
                        return modelNormal(reading, selftest::Mistake::none, point);
                    }));
        if (!examination.belts) continue;  // heights in whole bytes
        EXPECT_LE(examination.belts->wrong, 0.02) << describe(reading);
    }
}

TEST(ReadBelts, JudgeNoAxisWhoseTiltsAreFarWeakerThanTheOthers) {
    // An axis as it may be measured.
    const Parametrisation measured({0.0007, 1.0, 0.0007}, 0.5, false);
    for (const auto& [timesU, timesV] :
         {std::pair{1.0, 3000.0}, std::pair{1.0, 30000.0}, std::pair{3000.0, 1.0}}) {
        const auto unequal = tests::inProportion(
            tests::kParametrisation, [u = timesU, v = timesV](const auto&, const Point&) {
                return std::pair{u * 1e-3, v * 1e-3};
            });
        for (std::uint64_t seed = 1; seed <= 5; ++seed)
            EXPECT_TRUE(beltsOf(unequal, seed, measured).good()) << timesU << " " << timesV;
    }
}

TEST(ReadBelts, JudgeAnAxisWhoseTiltsAreAHundredTimesWeaker) {
    const auto striped =
        tests::inProportion(tests::kParametrisation, [](const tests::Place&, const Point& point) {
            const Vector3 n = tests::smooth(point);
            return std::pair{std::abs(n.x) < kNearly ? -0.01 : 0.01, 1.0};
        });
    const Belts belts = beltsOf(striped, 1);
    EXPECT_FALSE(belts.good()) << belts.wrong;
    EXPECT_EQ(belts.plane, 'x');
}

TEST(BeltWords, NameThePlaneAndTheCondition) {
    const Words words = beltWords({0.8, 'z'});
    EXPECT_NE(words.message.find("Beside the plane z = 0"), std::string::npos) << words.message;
    EXPECT_NE(words.message.find("80 % of the points"), std::string::npos) << words.message;
    EXPECT_NE(words.hint.find("std::atan2 takes any two numbers"), std::string::npos);
}

}  // namespace
}  // namespace ticker::tasks::bump
