#include <grader/tests/support/TemporaryFolder.h>

#include "RunTicker.h"

#include <raytracer/io/ImageReader.h>
#include <raytracer/io/ImageWriter.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

class CompareVerb : public testing::Test {
protected:
    /// A brightness ramp with random differences of one byte.
    std::string picture(const std::string& name, int width, int height, int noise) {
        raytracer::ByteImage image{width, height, {}};
        unsigned state = static_cast<unsigned>(noise);
        for (int i = 0; i < width * height * 3; ++i) {
            state = 1664525U * state + 1013904223U;
            const int grain = noise == 0 ? 0 : static_cast<int>(state >> 30U) - 1;
            image.rgb.push_back(static_cast<std::uint8_t>(60 + i % (width * 3) / 4 + grain));
        }
        const fs::path file = folder_.path() / name;
        raytracer::writePng(image, file);
        return "'" + file.string() + "'";
    }

    Ran run(const std::string& arguments) {
        return runTicker(arguments, (folder_.path() / "errors").string());
    }

    tests::TemporaryFolder folder_;
};

TEST_F(CompareVerb, SaysThatAPictureEqualsItself) {
    const std::string one = picture("one.png", 64, 48, 0);
    const Ran ran = run("compare " + one + " " + one);
    EXPECT_EQ(ran.status, 0);
    EXPECT_NE(ran.output.find("equal: every pixel is the same"), std::string::npos) << ran.output;
    EXPECT_EQ(ran.errors, "");
}

TEST_F(CompareVerb, SaysThatTwoNoisyPicturesAreEqualUpToNoise) {
    const Ran ran =
        run("compare " + picture("one.png", 64, 48, 1) + " " + picture("two.png", 64, 48, 2));
    EXPECT_EQ(ran.status, 0);
    EXPECT_NE(ran.output.find("equal up to noise"), std::string::npos) << ran.output;
}

// The false-alarm rate is 1e-6 for the whole picture.
TEST_F(CompareVerb, TellsOtherSeedsFromAnotherAperture) {
    const auto render = [&](const std::string& name, const std::string& how) {
        const std::string file = "'" + (folder_.path() / name).string() + "'";
        const Ran ran = run("render '" TICKER_SOURCE_DIR "/scenes/distributed.xml' -r 160x120 -o " +
                            file + " " + how);
        EXPECT_EQ(ran.status, 0) << ran.errors;
        return file;
    };
    const std::string one = render("one.png", "--seed 1");
    const std::string other = run("compare " + one + " " + render("two.png", "--seed 2")).output;
    EXPECT_NE(other.find("equal up to noise"), std::string::npos) << other;
    const std::string half =
        render("half.png", "--seed 3 --solution '" TICKER_SOURCE_DIR
                           "/grader/corpus/samples/awarded/distributed-half-width'");
    const Ran ran = run("compare --json " + one + " " + half);
    const nlohmann::json json = nlohmann::json::parse(ran.output);
    EXPECT_EQ(json.at("outcome"), "different") << ran.output;
    EXPECT_GT(json.at("where").at("box").at("rmse"), 3.0) << ran.output;
}

TEST_F(CompareVerb, GivesJsonThatAProgramCanRead) {
    const std::string one = picture("one.png", 64, 48, 0);
    const Ran ran = run("compare --json " + one + " " + one);
    const nlohmann::json json = nlohmann::json::parse(ran.output);
    EXPECT_EQ(json.at("width"), 64);
    EXPECT_EQ(json.at("metrics").at("flip"), 0.0);
    EXPECT_TRUE(json.at("metrics").at("psnr").is_null()) << "infinite is no JSON number";
    EXPECT_EQ(json.at("noise").at("differing"), 0);
}

TEST_F(CompareVerb, WritesAPictureOfEveryMap) {
    const fs::path maps = folder_.path() / "deep" / "maps";
    const Ran ran = run("compare --quiet --maps '" + maps.string() + "' " +
                        picture("one.png", 64, 48, 1) + " " + picture("two.png", 64, 48, 2));
    EXPECT_EQ(ran.status, 0) << ran.errors;
    EXPECT_EQ(ran.errors, "");
    for (const char* name : {"flip", "ssim", "gmsd", "ciede2000", "largestDifference", "noise"})
        EXPECT_GT(raytracer::readImage(maps / (std::string{name} + ".png")).width, 0) << name;
}

TEST_F(CompareVerb, RefusesPicturesOfDifferentSizesInOneLineThatNamesBoth) {
    const Ran ran =
        run("compare " + picture("one.png", 64, 48, 0) + " " + picture("two.png", 48, 64, 0));
    EXPECT_EQ(ran.status, 2);
    EXPECT_NE(ran.errors.find("two.png: 48 x 64 pixels"), std::string::npos) << ran.errors;
    EXPECT_NE(ran.errors.find("64 x 48"), std::string::npos) << ran.errors;
    EXPECT_EQ(std::count(ran.errors.begin(), ran.errors.end(), '\n'), 1) << ran.errors;
}

TEST_F(CompareVerb, RefusesWhatIsNoPicture) {
    folder_.write("text.png", "no picture");
    const std::string one = picture("one.png", 64, 48, 0);
    EXPECT_EQ(run("compare " + one + " '" + (folder_.path() / "text.png").string() + "'").status,
              2);
    EXPECT_EQ(run("compare " + one + " '" + (folder_.path() / "none.png").string() + "'").status,
              2);
    EXPECT_EQ(run("compare " + one).status, 2);
    EXPECT_EQ(run("compare --ppd 0 " + one + " " + one).status, 2);
}

}  // namespace
}  // namespace ticker::cli
