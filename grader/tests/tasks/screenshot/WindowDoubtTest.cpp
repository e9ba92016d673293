// Windows can disprove a picture only if the code renders a region as that part of a whole frame.
#include <grader/tasks/screenshot/WindowDoubt.h>
#include <grader/tests/tasks/screenshot/GreyExaminee.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <utility>

namespace ticker::tasks::screenshot {
namespace {

using raytracer::RenderSettings;

/// The grey of pixel (x, y) of a region's image.
using GreyOfPart = std::function<double(const RenderSettings&, int x, int y)>;

/// A frame that is brighter to the right and below.
double slopeAt(double column, double row) {
    return 0.1 + 0.002 * column + 0.004 * row;
}

/// The frame with the noise of a seed for each place.
double frameAt(const RenderSettings& settings, int column, int row) {
    return slopeAt(column, row) +
           0.1 * noiseOf(settings.seed, static_cast<std::uint64_t>(1000 * row + column), 0);
}

double partAt(const RenderSettings& settings, int x, int y) {
    return frameAt(settings, settings.region.x + x, settings.region.y + y);
}

/// Renders whole frames as frameAt says, and regions by `part`.
GreyExaminee codeOfParts(GreyOfPart part) {
    return GreyExaminee{{.grey = [part = std::move(part)](const GreyPixel& pixel) {
        const RenderSettings& settings = pixel.settings;
        return settings.region.isWholeFrame() ? frameAt(settings, pixel.x, pixel.y)
                                              : part(settings, pixel.x, pixel.y);
    }}};
}

std::optional<Verification> doubtOf(probe::Examinee& code, bool isRandom = true) {
    const raytracer::SceneDescription description;
    Scene scene;
    scene.isRandom = isRandom;
    scene.description = &description;
    scene.examinee = &code;
    return doubtOfWindows(scene, 4);
}

TEST(DoubtOfWindows, IsNoneWherePartsAreThoseOfTheWholeAndNeedsTwoRunsOfOneRay) {
    for (const bool isRandom : {true, false}) {
        GreyExaminee code = codeOfParts(partAt);
        EXPECT_FALSE(doubtOf(code, isRandom));
        EXPECT_EQ(code.runs(), 2U);
    }
}

TEST(DoubtOfWindows, IsNoneWherePartsDifferInNoiseAlone) {
    for (std::uint64_t other = 1; other <= 20; ++other) {
        GreyExaminee code = codeOfParts([=](RenderSettings settings, int x, int y) {
            settings.seed += other;
            return partAt(settings, x, y);
        });
        EXPECT_FALSE(doubtOf(code)) << other;
    }
}

TEST(DoubtOfWindows, IsThereWherePartsShowAnotherPlace) {
    const std::pair<const char*, GreyOfPart> wrong[] = {
        {"added twice", [](const RenderSettings& s, int x,
                           int y) { return frameAt(s, x + 2 * s.region.x, y + 2 * s.region.y); }},
        {"upside down",
         [](const RenderSettings& s, int x, int y) {
             return frameAt(s, x + s.region.x, s.region.y + s.region.height - 1 - y);
         }},
        {"counted from below",
         [](const RenderSettings& s, int x, int y) {
             return frameAt(s, x + s.region.x, s.height - s.region.y - s.region.height + y);
         }},
        {"ignored", [](const RenderSettings& s, int x, int y) { return frameAt(s, x, y); }},
        {"a camera of the region's size",
         [](const RenderSettings& s, int x, int y) {
             return frameAt(s, x * s.width / s.region.width, y * s.height / s.region.height);
         }},
        {"x and y exchanged", [](const RenderSettings& s, int x,
                                 int y) { return frameAt(s, x + s.region.y, y + s.region.x); }},
    };
    for (const auto& [name, part] : wrong)
        for (const bool isRandom : {true, false}) {
            GreyExaminee code = codeOfParts(part);
            const std::optional<Verification> said = doubtOf(code, isRandom);
            ASSERT_TRUE(said) << name;
            EXPECT_EQ(said->kind, Verification::Kind::unknown) << name;
            EXPECT_NE(said->why.find("--region"), std::string::npos) << said->why;
            EXPECT_FALSE(said->own) << name;
        }
}

TEST(DoubtOfWindows, IsThereWherePartsHaveAnotherNoise) {
    GreyExaminee code = codeOfParts([](const RenderSettings& settings, int x, int y) {
        const int column = settings.region.x + x;
        const int row = settings.region.y + y;
        return slopeAt(column, row) + 0.05 +
               4.0 * (frameAt(settings, column, row) - 0.05 - slopeAt(column, row));
    });
    EXPECT_TRUE(doubtOf(code));
}

TEST(DoubtOfWindows, IsThereWhereNothingIsAnsweredAndOursWhereWeFailed) {
    EndingExaminee slow{{probe::ProcessEnd::Kind::timedOut, ""}};
    const std::optional<Verification> said = doubtOf(slow);
    ASSERT_TRUE(said);
    EXPECT_EQ(said->kind, Verification::Kind::unknown);
    EXPECT_NE(said->why, "");
    EndingExaminee ours{{probe::ProcessEnd::Kind::ourFault, "no memory"}};
    const std::optional<Verification> failed = doubtOf(ours);
    ASSERT_TRUE(failed);
    EXPECT_EQ(failed->kind, Verification::Kind::ourFault);
    EXPECT_EQ(failed->why, "no memory");
}

}  // namespace
}  // namespace ticker::tasks::screenshot
