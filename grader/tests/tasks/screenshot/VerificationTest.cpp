#include <grader/tasks/screenshot/Verification.h>

#include <raytracer/image/ToneCurve.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace ticker::tasks::screenshot {
namespace {

/// Grey with equal noise in every channel, linear.
class Noise {
public:
    explicit Noise(std::uint32_t seed) : state_(seed) {}
    [[nodiscard]] raytracer::ColourRGB colour(double grey) {
        state_ = state_ * 1664525U + 1013904223U;
        return raytracer::ColourRGB{grey + 0.1 * (state_ >> 16U) / 65536.0};
    }

private:
    std::uint32_t state_;
};

/// Renders the next of these greys in each run; no answer after the last one.
class GreyCode final : public probe::Examinee {
public:
    explicit GreyCode(std::vector<double> greys) : greys_(std::move(greys)) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        probe::Run run;
        for (const probe::Question& question : questions) {
            const auto& settings = std::get<probe::RenderQuestion>(question).settings;
            probe::RenderAnswer answer;
            answer.width = settings.imageWidth();
            answer.height = settings.imageHeight();
            answer.images.resize(1);
            if (runs_ < greys_.size()) answer.state = probe::AnswerState::answered;
            for (int i = 0; i < answer.width * answer.height && runs_ < greys_.size(); ++i)
                answer.images[0].push_back(noise_.colour(greys_[runs_]));
            run.answers.emplace_back(std::move(answer));
        }
        ++runs_;
        return run;
    }
    [[nodiscard]] std::size_t runs() const { return runs_; }

private:
    std::vector<double> greys_;
    Noise noise_{7};
    std::size_t runs_ = 0;
};

/// What is said of a picture of grey 0.3, and how often the code ran, if it renders one of these
/// greys in each run.
struct Said {
    Verification verification;
    std::size_t runs;
};
Said say(const std::vector<double>& greys, bool isDeterministic = false) {
    GreyCode code{greys};
    const raytracer::SceneDescription description;
    Scene scene;
    scene.isRandom = !isDeterministic;
    scene.description = &description;
    scene.examinee = &code;
    Picture picture{640, 480, {}};
    Noise noise{1};
    for (int i = 0; i < picture.width * picture.height; ++i)
        for (const std::uint8_t byte : raytracer::toneMapped(noise.colour(0.3)))
            picture.rgb.push_back(byte);
    return {verify(picture.view(), scene, 5), code.runs()};
}

/// Answers nothing; its process ends in this way.
class Ending final : public probe::Examinee {
public:
    explicit Ending(probe::ProcessEnd end) : end_(std::move(end)) {}
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        return {std::vector<probe::Answer>(questions.size(), probe::RenderAnswer{}), end_};
    }

private:
    probe::ProcessEnd end_;
};

Verification verifyBlack(probe::Examinee& code) {
    const raytracer::SceneDescription description;
    Scene scene;
    scene.description = &description;
    scene.examinee = &code;
    const Picture picture{640, 480, std::vector<std::uint8_t>(std::size_t{3} * 640 * 480, 0)};
    return verify(picture.view(), scene, 5);
}

TEST(Verify, TellsOurFailureFromTheCodes) {
    using Kind = probe::ProcessEnd::Kind;
    Ending ours{{Kind::ourFault, "no memory for the sandbox"}};
    EXPECT_EQ(verifyBlack(ours).kind, Verification::Kind::ourFault);
    EXPECT_EQ(verifyBlack(ours).why, "no memory for the sandbox");
    for (const Kind kind : {Kind::crashed, Kind::timedOut, Kind::memory, Kind::exitedEarly}) {
        Ending bad{{kind, ""}};
        EXPECT_EQ(verifyBlack(bad).kind, Verification::Kind::unknown);
        EXPECT_EQ(verifyBlack(bad).why,
                  "this code did not finish when it was asked for parts of the frame");
    }
    Ending whole{{Kind::finished, ""}};
    EXPECT_EQ(verifyBlack(whole).why, "this code renders whole frames only, no part of one");
}

// An agreement is missed with a chance of 5e-4; the seeds are fixed.
TEST(Verify, AsksOnceWhereTheWindowsAgree) {
    const auto [verification, runs] = say({0.3});
    EXPECT_EQ(verification.kind, Verification::Kind::same);
    EXPECT_EQ(runs, 1U);
    ASSERT_TRUE(verification.own);
    EXPECT_EQ(verification.own->windows.boxes, drawWindows(false, 640, 480, 5, 0).boxes);
}

TEST(Verify, AsksAgainElsewhereWhereTheyDiffer) {
    const auto [once, runs] = say({0.5, 0.3});
    EXPECT_EQ(once.kind, Verification::Kind::same);
    EXPECT_EQ(runs, 2U);
    EXPECT_EQ(once.own->windows.boxes, drawWindows(false, 640, 480, 5, 0).boxes)
        << "where it differed";
    const auto [twice, two] = say({0.5, 0.5});
    EXPECT_EQ(twice.kind, Verification::Kind::different);
    EXPECT_EQ(two, 2U);
    EXPECT_EQ(twice.own->windows.boxes, drawWindows(false, 640, 480, 5, 1).boxes);
}

TEST(Verify, AsksOnceWhereNothingIsRandom) {
    const auto [verification, runs] = say({0.7, 0.7, 0.7}, true);
    EXPECT_EQ(verification.kind, Verification::Kind::different);
    EXPECT_EQ(runs, 1U);
}

TEST(Verify, KnowsNothingWithoutAnswersOrWithoutCode) {
    EXPECT_EQ(say({}).verification.kind, Verification::Kind::unknown);
    EXPECT_FALSE(say({}).verification.why.empty());
    EXPECT_EQ(say({0.5}).verification.kind, Verification::Kind::unknown) << "no second answer";
    const Verification without = verify({}, Scene{}, 1);
    EXPECT_EQ(without.kind, Verification::Kind::unknown);
    EXPECT_TRUE(without.why.empty());
}

}  // namespace
}  // namespace ticker::tasks::screenshot
