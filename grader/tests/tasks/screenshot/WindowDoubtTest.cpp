// Windows can disprove a picture only if the code renders a region as that part of a whole frame.
#include <grader/tasks/screenshot/WindowDoubt.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <utility>

namespace ticker::tasks::screenshot {
namespace {

using raytracer::RenderSettings;

/// The grey of pixel (x, y) of a region's image.
using GreyOfPart = std::function<double(const RenderSettings&, int x, int y)>;

double noiseAt(std::uint64_t a, std::uint64_t b) {
    std::uint64_t mixed = a * 0x9E3779B97F4A7C15U + b * 0xD1342543DE82EF95U + 1;
    for (int i = 0; i < 3; ++i)
        mixed = (mixed ^ (mixed >> 31U)) * 0xBF58476D1CE4E5B9U;
    return static_cast<double>(mixed >> 11U) * 0x1p-53;
}

/// A frame that is brighter to the right and below.
double slopeAt(double column, double row) {
    return 0.1 + 0.002 * column + 0.004 * row;
}

/// The frame with the noise of a seed for each place.
double frameAt(const RenderSettings& settings, int column, int row) {
    return slopeAt(column, row) +
           0.1 * noiseAt(settings.seed, static_cast<std::uint64_t>(1000 * row + column));
}

double partAt(const RenderSettings& settings, int x, int y) {
    return frameAt(settings, settings.region.x + x, settings.region.y + y);
}

class CodeOfParts final : public probe::Examinee {
public:
    explicit CodeOfParts(GreyOfPart part) : part_(std::move(part)) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        ++runs_;
        probe::Run run;
        for (const probe::Question& question : questions)
            run.answers.emplace_back(render(std::get<probe::RenderQuestion>(question).settings));
        return run;
    }
    [[nodiscard]] int runs() const { return runs_; }

private:
    [[nodiscard]] probe::RenderAnswer render(const RenderSettings& settings) const {
        probe::RenderAnswer answer;
        answer.state = probe::AnswerState::answered;
        answer.width = settings.imageWidth();
        answer.height = settings.imageHeight();
        answer.images.resize(1);
        const GreyOfPart& grey = settings.region.isWholeFrame() ? GreyOfPart{frameAt} : part_;
        for (int y = 0; y < answer.height; ++y)
            for (int x = 0; x < answer.width; ++x)
                answer.images[0].emplace_back(grey(settings, x, y));
        return answer;
    }

    GreyOfPart part_;
    int runs_ = 0;
};

/// Answers nothing; its process ends in this way.
class EndingAtOnce final : public probe::Examinee {
public:
    explicit EndingAtOnce(probe::ProcessEnd::Kind kind) : kind_(kind) {}
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        return {std::vector<probe::Answer>(questions.size(), probe::RenderAnswer{}),
                {kind_, "no memory"}};
    }

private:
    probe::ProcessEnd::Kind kind_;
};

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
        CodeOfParts code{partAt};
        EXPECT_FALSE(doubtOf(code, isRandom));
        EXPECT_EQ(code.runs(), 2);
    }
}

TEST(DoubtOfWindows, IsNoneWherePartsDifferInNoiseAlone) {
    for (std::uint64_t other = 1; other <= 20; ++other) {
        CodeOfParts code{[=](RenderSettings settings, int x, int y) {
            settings.seed += other;
            return partAt(settings, x, y);
        }};
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
            CodeOfParts code{part};
            const std::optional<Verification> said = doubtOf(code, isRandom);
            ASSERT_TRUE(said) << name;
            EXPECT_EQ(said->kind, Verification::Kind::unknown) << name;
            EXPECT_NE(said->why.find("--region"), std::string::npos) << said->why;
            EXPECT_FALSE(said->own) << name;
        }
}

TEST(DoubtOfWindows, IsThereWherePartsHaveAnotherNoise) {
    CodeOfParts code{[](const RenderSettings& settings, int x, int y) {
        const int column = settings.region.x + x;
        const int row = settings.region.y + y;
        return slopeAt(column, row) + 0.05 +
               4.0 * (frameAt(settings, column, row) - 0.05 - slopeAt(column, row));
    }};
    EXPECT_TRUE(doubtOf(code));
}

TEST(DoubtOfWindows, IsThereWhereNothingIsAnsweredAndOursWhereWeFailed) {
    EndingAtOnce slow{probe::ProcessEnd::Kind::timedOut};
    const std::optional<Verification> said = doubtOf(slow);
    ASSERT_TRUE(said);
    EXPECT_EQ(said->kind, Verification::Kind::unknown);
    EXPECT_NE(said->why, "");
    EndingAtOnce ours{probe::ProcessEnd::Kind::ourFault};
    const std::optional<Verification> failed = doubtOf(ours);
    ASSERT_TRUE(failed);
    EXPECT_EQ(failed->kind, Verification::Kind::ourFault);
    EXPECT_EQ(failed->why, "no memory");
}

}  // namespace
}  // namespace ticker::tasks::screenshot
