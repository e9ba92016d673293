#include <grader/tests/tasks/lens/LensByHand.h>

#include <raytracer/image/ToneCurve.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace ticker::tasks {
namespace {

using Values = std::vector<ColourRGB>;

const Values kBright{{0.2, 0.4, 0.6}, {0.6, 0.2, 0.0}};
const Values kCorner{{1.6, 0.2, 0.1}, {0.2, 0.4, 0.3}, {0.001, 0.001, 0.001}};

ColourRGB meanOf(const Values& values) {
    ColourRGB sum;
    for (const ColourRGB& value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

/// Two pixels whose rays have the values kBright and kCorner. `colourOf` computes the colour of a
/// pixel from its values.
template <typename ColourOf>
std::optional<Finding> judgeAverageOf(const ColourOf& colourOf, int asked = 2) {
    LensByHand lens;
    lens.asked.settings.dofRayCount = asked;
    for (const Values& values : {kBright, kCorner}) {
        LensPixel& pixel = lens.pixel();
        for (const ColourRGB& value : values) {
            pixel.rays.push_back(rayThrough({}, {0.0, 0.0, 1.0}));
            pixel.rays.back().value = value;
        }
        pixel.colour = colourOf(values);
    }
    return checkAverage(lens.log);
}

bool says(const std::optional<Finding>& finding, const std::string& words) {
    return finding && finding->id == "dof.not-averaged" &&
           finding->message.find(words) != std::string::npos;
}

TEST(Average, IsThatOfAllRaysOrOfAllButAnExtraOne) {
    EXPECT_FALSE(judgeAverageOf(meanOf));
    EXPECT_FALSE(judgeAverageOf([](Values values) {
        values.resize(2);
        return meanOf(values);
    })) << "an extra ray at the end";
    EXPECT_FALSE(judgeAverageOf([](const Values& values) {
        return meanOf({values.end() - 2, values.end()});
    })) << "at the beginning";
    EXPECT_TRUE(judgeAverageOf(
        [](const Values& values) {
            return meanOf({values.end() - 2, values.end()});
        },
        3))
        << "no more than were asked for";
}

TEST(Average, LeavesOutSeveralExtraRays) {
    LensByHand lens;
    lens.asked.settings.dofRayCount = 1;
    LensPixel& pixel = lens.pixel();
    for (const ColourRGB& value : kCorner) {
        pixel.rays.push_back(rayThrough({}, {0.0, 0.0, 1.0}));
        pixel.rays.back().value = value;
    }
    pixel.colour = kCorner.back();
    EXPECT_FALSE(checkAverage(lens.log));
    pixel.colour = kCorner[1];
    EXPECT_TRUE(checkAverage(lens.log)) << "the middle one is neither end";
}

TEST(Average, HoldsInEveryChannelUpToSinglePrecision) {
    LensByHand lens;
    LensPixel& pixel = lens.pixel();
    for (const ColourRGB& value : kBright) {
        pixel.rays.push_back(rayThrough({}, {0.0, 0.0, 1.0}));
        pixel.rays.back().value = value;
    }
    for (const ColourRGB& channel :
         {ColourRGB{1.0, 0.0, 0.0}, ColourRGB{0.0, 1.0, 0.0}, ColourRGB{0.0, 0.0, 1.0}})
        for (const double side : {-1.0, 1.0}) {
            pixel.colour = ColourRGB{0.4, 0.3, 0.3} + channel * (side * 2.9e-5);
            EXPECT_FALSE(checkAverage(lens.log)) << "of a sum of 1";
            pixel.colour = ColourRGB{0.4, 0.3, 0.3} + channel * (side * 3.1e-5);
            EXPECT_TRUE(checkAverage(lens.log));
        }
}

TEST(CheckAverage, SaysByWhichFactorTheMeanIsMultiplied) {
    const auto finding = judgeAverageOf([](const Values& values) { return meanOf(values) * 0.7; });
    ASSERT_TRUE(says(finding, "0.7 times"));
    EXPECT_NEAR(numberIn(*finding, "factor"), 0.7, 1e-9);
}

TEST(CheckAverage, SaysThatTheColourIsThatOfOneRay) {
    EXPECT_TRUE(
        says(judgeAverageOf([](const Values& values) { return values.back(); }), "last ray"));
    EXPECT_TRUE(
        says(judgeAverageOf([](const Values& values) { return values.front(); }), "first ray"));
}

TEST(CheckAverage, SaysThatTheColourIsThatOfOneRayDividedByTheNumberOfRays) {
    const auto part = [](const ColourRGB& one, const Values& values) {
        return one / static_cast<double>(values.size());
    };
    EXPECT_TRUE(says(judgeAverageOf([&](const Values& v) { return part(v.back(), v); }),
                     "of the last ray alone, divided by"));
    EXPECT_TRUE(says(judgeAverageOf([&](const Values& v) { return part(v.front(), v); }),
                     "of the first ray alone, divided by"));
}

TEST(CheckAverage, SaysWhichRayTheSumLeavesOutAlthoughTheDivisorCountsIt) {
    const auto without = [](bool first) {
        return judgeAverageOf([=](const Values& values) {
            ColourRGB sum;
            for (std::size_t i = 0; i < values.size(); ++i)
                if (i != (first ? 0 : values.size() - 1)) sum += values[i];
            return sum / static_cast<double>(values.size());
        });
    };
    EXPECT_TRUE(says(without(true), "first ray is left out of the sum"));
    EXPECT_TRUE(says(without(false), "last ray is left out of the sum"));
}

TEST(CheckAverage, SaysThatBrightColoursAreCutOffOrThatMissesAreLeftOut) {
    EXPECT_TRUE(says(judgeAverageOf(
                         [](Values values) {
                             for (ColourRGB& value : values)
                                 value = {std::min(1.0, value.r), value.g, value.b};
                             return meanOf(values);
                         },
                         3),
                     "cut off"));
    EXPECT_TRUE(says(judgeAverageOf(
                         [](Values values) {
                             if (values.size() > 2) values.pop_back();
                             return meanOf(values);
                         },
                         3),
                     "hit nothing"));
}

TEST(CheckAverage, NamesTheToneCurveOrTheIntegerDivision) {
    EXPECT_TRUE(says(judgeAverageOf([](Values values) {
                         for (ColourRGB& value : values) {
                             const auto bytes = raytracer::toneMapped(value);
                             value = {bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0};
                         }
                         return meanOf(values);
                     }),
                     "tone curve"));
    EXPECT_TRUE(says(judgeAverageOf([](const Values&) { return ColourRGB{}; }), "1 / n"));
}

TEST(CheckAverage, NamesACurveThatTheColoursWentThrough) {
    const auto through = [](double (*curve)(double), double factor) {
        return judgeAverageOf([=](Values values) {
            for (ColourRGB& c : values)
                c = ColourRGB{curve(c.r), curve(c.g), curve(c.b)} * factor;
            return meanOf(values);
        });
    };
    const auto toned = [](double c) {
        const double p = std::pow(c, 1.3);
        return std::pow(p / (p + std::pow(0.25, 1.3)), 1.0 / 2.2);
    };
    for (const double factor : {1.0, 255.0})
        EXPECT_TRUE(says(through(toned, factor), "tone curve before"));
    EXPECT_TRUE(says(through([](double c) { return std::pow(c, 1.0 / 2.2); }, 1.0), "a power"));
    EXPECT_TRUE(says(through([](double c) { return std::sqrt(c); }, 1.0), "a power"));
    EXPECT_TRUE(says(through([](double c) { return c / (1.0 + c); }, 1.0), "a power"));
    EXPECT_FALSE(says(through([](double c) { return std::sin(3.0 * c); }, 1.0), "before"));
}

TEST(CheckAverage, GivesAHintWhereNothingExplainsTheColour) {
    const auto strange = judgeAverageOf([](const Values&) { return ColourRGB{9.0, 0.0, 4.0}; });
    ASSERT_EQ(idOf(strange), "dof.wrong");
    EXPECT_NE(strange->hint.find("start at 0"), std::string::npos);
    EXPECT_NE(strange->hint.find("mixes neighbours"), std::string::npos);
}

TEST(CheckAverage, SaysThatRaysCountUnevenlyWhereTheColourLiesBetweenThem) {
    const auto weighed = [](const Values& values) {
        return values.front() * 0.8 + values[1] * 0.2;
    };
    EXPECT_TRUE(says(judgeAverageOf(weighed), "count more"));
    for (const ColourRGB& channel :
         {ColourRGB{1.0, 0.0, 0.0}, ColourRGB{0.0, 1.0, 0.0}, ColourRGB{0.0, 0.0, 1.0}})
        for (const double side : {-1.0, 1.0}) {
            const ColourRGB off = channel * (2.0 * side);
            EXPECT_EQ(idOf(judgeAverageOf([&](const Values& v) { return weighed(v) + off; })),
                      "dof.wrong");
        }
}

// In two channels both rays have the same value, so the colour may only be that value: rounding
// must not make it fall outside.
TEST(CheckAverage, SaysThatRaysCountUnevenlyWhereAChannelIsTheSameInAll) {
    for (const ColourRGB& channel :
         {ColourRGB{1.0, 0.0, 0.0}, ColourRGB{0.0, 1.0, 0.0}, ColourRGB{0.0, 0.0, 1.0}}) {
        LensByHand lens;
        LensPixel& pixel = lens.pixel();
        const ColourRGB first{0.2, 0.4, 0.6};
        for (const ColourRGB& value : {first, first + channel}) {
            pixel.rays.push_back(rayThrough({}, {0.0, 0.0, 1.0}));
            pixel.rays.back().value = value;
        }
        pixel.colour = first + channel * 0.2;
        LensPixel other = pixel;
        other.colour = first + channel * 0.9;
        lens.log.pixels.push_back(other);
        const auto finding = checkAverage(lens.log);
        EXPECT_TRUE(says(finding, "count more")) << (finding ? finding->message : "");
    }
}

TEST(Average, IsNotJudgedWhereTheLogIsCutOrHasNoValues) {
    LensByHand lens;
    LensPixel& pixel = lens.pixel();
    pixel.rays.push_back(rayThrough({}, {0.0, 0.0, 1.0}));
    pixel.colour = {0.5, 0.5, 0.5};
    EXPECT_FALSE(checkAverage(lens.log)) << "another recursion";
    pixel.rays[0].value = ColourRGB{0.1, 0.7, 0.1};
    EXPECT_TRUE(checkAverage(lens.log));
    lens.log.cut = true;
    EXPECT_FALSE(checkAverage(lens.log));
}

}  // namespace
}  // namespace ticker::tasks
