#include <grader/tasks/screenshot/Verification.h>
#include <grader/tests/tasks/screenshot/GreyExaminee.h>

#include <raytracer/image/ToneCurve.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace ticker::tasks::screenshot {
namespace {

/// Adds noise to a linear grey.
class Noise {
public:
    explicit Noise(std::uint32_t seed) : state_(seed) {}
    [[nodiscard]] double added(double grey) {
        state_ = state_ * 1664525U + 1013904223U;
        return grey + 0.1 * (state_ >> 16U) / 65536.0;
    }

private:
    std::uint32_t state_;
};

/// What is said of a picture of grey 0.3, and how often the code ran, if it renders the next of
/// these greys in each run and answers no more after the last one.
struct Said {
    Verification verification;
    std::size_t runs;
};
Said say(const std::vector<double>& greys, bool isDeterministic = false) {
    GreyExaminee code{
        {.grey = [&greys, noise = Noise{7}](
                     const GreyPixel& pixel) mutable { return noise.added(greys[pixel.run]); },
         .answeredRuns = greys.size()}};
    const raytracer::SceneDescription description;
    Scene scene;
    scene.isRandom = !isDeterministic;
    scene.description = &description;
    scene.examinee = &code;
    Picture picture{640, 480, {}};
    Noise noise{1};
    for (int i = 0; i < picture.width * picture.height; ++i)
        for (const std::uint8_t byte :
             raytracer::toneMapped(raytracer::ColourRGB{noise.added(0.3)}))
            picture.rgb.push_back(byte);
    return {verify(picture.view(), scene, 5), code.runs()};
}

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
    EndingExaminee ours{{Kind::ourFault, "no memory for the sandbox"}};
    EXPECT_EQ(verifyBlack(ours).kind, Verification::Kind::ourFault);
    EXPECT_EQ(verifyBlack(ours).why, "no memory for the sandbox");
    for (const Kind kind : {Kind::crashed, Kind::timedOut, Kind::memory, Kind::exitedEarly}) {
        EndingExaminee bad{{kind, ""}};
        EXPECT_EQ(verifyBlack(bad).kind, Verification::Kind::unknown);
        EXPECT_EQ(verifyBlack(bad).why,
                  "this code did not finish when it was asked for parts of the frame");
    }
    EndingExaminee whole{{Kind::finished, ""}};
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
