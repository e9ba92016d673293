// Code whose renders of a region are wrong, and whose whole frames are right.
#include <grader/lab/selftest/OracleExaminee.h>
#include <grader/lab/selftest/PictureTricks.h>
#include <grader/lab/selftest/ScreenshotStudent.h>
#include <grader/metrics/Alignment.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace ticker::selftest {
namespace {

using pipeline::SpecScene;

const std::vector<SpecScene>& specScenes() {
    static const std::vector<SpecScene> read =
        pipeline::readSpecScenes(std::filesystem::path{TICKER_SOURCE_DIR} / "scenes",
                                 std::filesystem::path{TICKER_SOURCE_DIR} / "assets");
    return read;
}

std::string idOf(const TaskJudgement& judgement) {
    return judgement.findings.empty() ? "" : judgement.findings.front().id;
}

/// Whole frames as the oracle renders them; parts of a frame after a change of the question.
class WrongParts final : public probe::Examinee {
public:
    using Change = void (*)(raytracer::RenderSettings&);
    explicit WrongParts(Change change) : change_(change) {}
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        std::vector<probe::Question> changed = questions;
        for (probe::Question& question : changed) {
            auto& settings = std::get<probe::RenderQuestion>(question).settings;
            if (!settings.region.isWholeFrame()) change_(settings);
        }
        return OracleExaminee{{}, {}, false}.ask(changed);
    }

private:
    Change change_;
};

// Students use the program's --region for trials only; the picture that they hand in is a whole
// frame.
constexpr WrongParts::Change kWrongParts[] = {
    [](raytracer::RenderSettings& s) {  // the corner is added twice
        s.region.x *= 2;
        s.region.y *= 2;
    },
    [](raytracer::RenderSettings& s) {  // rows are counted from below
        s.region.y = s.height - s.region.y - s.region.height;
    },
    [](raytracer::RenderSettings& s) {  // the corner is ignored
        s.region.x = s.region.y = 0;
    },
    [](raytracer::RenderSettings& s) {  // a camera of the region's size
        s.width = s.region.width;
        s.height = s.region.height;
        s.region = {};
    }};

TEST(JudgeScreenshotOfWrongParts, BlamesNobodyWhoseCodeRendersRegionsOtherwise) {
    std::uint64_t seed = 1;
    for (const WrongParts::Change change : kWrongParts) {
        WrongParts code{change};
        const ScreenshotStudent student{specScenes(), false, code};
        double unused = 0.0;
        const TaskJudgement judgement = student.handIn(student.render(320, 77), seed++, unused);
        EXPECT_EQ(judgement.state, TaskState::passed);
        EXPECT_FALSE(judgement.needsReview);
        ASSERT_EQ(judgement.findings.size(), 1U);
        EXPECT_EQ(judgement.findings[0].id, "screenshot.unverified");
        EXPECT_EQ(judgement.findings[0].severity, Severity::note);
        EXPECT_NE(judgement.findings[0].message.find("--region"), std::string::npos);
    }
}

TEST(JudgeScreenshotOfWrongParts, FindsEditsAndOtherScenesWhereCodeRendersRegionsOtherwise) {
    WrongParts code{kWrongParts[0]};
    const ScreenshotStudent student{specScenes(), false, code};
    const Picture picture = student.render(320, 11);
    Picture negative = picture;
    for (std::uint8_t& byte : negative.rgb)
        byte = static_cast<std::uint8_t>(255 - byte);
    Picture covered = picture;
    for (std::size_t y = 100; y < 160; ++y)
        for (std::size_t x = 0; x < 3 * 60; ++x)
            covered.rgb[3 * (320 * y + 60) + x] = 255;
    double unused = 0.0;
    const auto handIn = [&](const Picture& other) { return student.handIn(other, 11, unused); };
    EXPECT_EQ(idOf(handIn(metrics::mirrored(picture.view(), metrics::Mirror::leftRight))),
              "screenshot.edited");
    EXPECT_EQ(idOf(handIn(negative)), "screenshot.edited");
    EXPECT_EQ(idOf(handIn(photograph(320, 240, 11))), "screenshot.not-this-scene");
    const TaskJudgement judgement = handIn(covered);
    EXPECT_EQ(idOf(judgement), "screenshot.not-from-this-code");
    EXPECT_TRUE(judgement.needsReview);
}

}  // namespace
}  // namespace ticker::selftest
