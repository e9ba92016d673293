#include "StudentProgram.h"

#include <raytracer/image/ToneCurve.h>
#include <raytracer/io/ImageReader.h>

#include <grader/tests/io/BytesOf.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace ticker {
namespace {

using raytracer::ByteImage;
using raytracer::readImage;
using testing::bytesOf;
using testing::ProgramResult;
using tests::TemporaryFolder;

const std::string kSceneFiles = std::string(TICKER_SOURCE_DIR) + "/scenes/";

class Tick1Star : public ::testing::Test {
protected:
    [[nodiscard]] std::string file(const std::string& name) const { return folder_.path() / name; }

    [[nodiscard]] ProgramResult run(const std::vector<std::string>& arguments) const {
        return testing::runTick1Star(arguments, folder_.path());
    }

    /// Renders a scene small and fast, with a seed; returns the file's bytes.
    std::string render(const std::string& scene, std::vector<std::string> more) const {
        std::vector<std::string> arguments{
            "-i",    kSceneFiles + scene, "-o", file("a.png"),   "--seed", "7", "-r",
            "80x60", "--dof-rays",        "8",  "--shadow-rays", "4"};
        std::ranges::move(more, std::back_inserter(arguments));
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return bytesOf(file("a.png"));
    }

    TemporaryFolder folder_;
};

TEST_F(Tick1Star, GivesTheSameBytesForTheSameSeed) {
    const std::string first = render("distributed.xml", {});

    EXPECT_FALSE(first.empty());
    EXPECT_EQ(render("distributed.xml", {}), first);
    EXPECT_NE(render("distributed.xml", {"--seed", "8"}), first);
}

TEST_F(Tick1Star, GivesTheSameBytesWhateverTheThreads) {
    const std::string one = render("distributed.xml", {"--threads", "1"});

    EXPECT_EQ(render("distributed.xml", {"--threads", "2"}), one);
    EXPECT_EQ(render("distributed.xml", {"--threads", "64"}), one);
}

TEST_F(Tick1Star, TakesAFreshSeedWhereNoneIsGiven) {
    // Two seeds of 64 bits are equal with probability 5e-20.
    const auto seedSaid = [this] {
        const ProgramResult result = run(
            {"-i", kSceneFiles + "lens-grid.xml", "-o", file("a.png"), "-r", "4x4", "--verbose"});
        return result.err.substr(0, result.err.find(','));
    };
    const std::string first = seedSaid();
    EXPECT_TRUE(first.starts_with("seed ")) << first;
    EXPECT_NE(seedSaid(), first);
}

TEST_F(Tick1Star, RendersARegionLikeTheSamePixelsOfTheWhole) {
    render("distributed.xml", {});
    const ByteImage whole = readImage(file("a.png"));
    render("distributed.xml", {"--region", "30,20,17,9"});
    const ByteImage part = readImage(file("a.png"));

    ASSERT_EQ(part.width, 17);
    ASSERT_EQ(part.height, 9);
    for (std::size_t y = 0; y < 9; ++y)
        for (std::size_t i = 0; i < 17 * 3; ++i)
            ASSERT_EQ(part.rgb[y * 17 * 3 + i], whole.rgb[((y + 20) * 80 + 30) * 3 + i])
                << "row " << y << ", byte " << i;
}

TEST_F(Tick1Star, TakesTheHandoutsConstantsAsOptions) {
    const std::string usual = render("distributed.xml", {});

    for (const std::vector<std::string>& change : {std::vector<std::string>{"--light-size", "1.5"},
                                                   {"--aperture", "0.01"},
                                                   {"--focal-plane", "6"},
                                                   {"--shadow-rays", "1"},
                                                   {"--dof-rays", "1"},
                                                   {"-b", "0"}})
        EXPECT_NE(render("distributed.xml", change), usual) << change[0];
}

TEST_F(Tick1Star, FindsTheAssetsFromItsOwnPlaceAndWhereItIsTold) {
    EXPECT_FALSE(render("bump-mapping.xml", {}).empty());
    const ProgramResult result = run(
        {"-i", kSceneFiles + "bump-mapping.xml", "-o", file("b.png"), "--assets", folder_.path()});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.err.find("bump-mapping.xml:6: bump-map=\"bumpmap.png\""), std::string::npos)
        << result.err;
    EXPECT_FALSE(std::filesystem::exists(file("b.png")));
}

TEST_F(Tick1Star, WritesLinearColoursThatGiveThePicture) {
    render("lens-grid.xml", {"--linear", file("a.pfm")});
    const ByteImage picture = readImage(file("a.png"));
    const std::string linear = bytesOf(file("a.pfm"));
    const std::string header = "PF\n80 60\n-1.0\n";
    ASSERT_EQ(linear.size(), header.size() + picture.rgb.size() * sizeof(float));

    for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
        const std::size_t row = 59 - i / 240;
        float value = 0.0F;
        std::memcpy(&value, linear.data() + header.size() + (row * 240 + i % 240) * sizeof(float),
                    sizeof(float));
        // A double that was rounded to a float may fall on the other side of a byte's edge.
        ASSERT_NEAR(raytracer::toneMapped(double{value}), picture.rgb[i], 1);
    }
}

TEST_F(Tick1Star, IsSilentWithoutATerminal) {
    const ProgramResult result =
        run({"-i", kSceneFiles + "lens-grid.xml", "-o", file("a.png"), "-r", "16x12"});

    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.out + result.err, "");
}

TEST_F(Tick1Star, RemindsOnlyOfTheStubsOfTheScenesOwnOption) {
    const auto said = [this](const std::string& scene, const std::string& more) {
        const ProgramResult result = testing::runTick1Star(
            {"-i", kSceneFiles + scene, "-o", file("a.png"), "-r", "16x12", more}, folder_.path(),
            "template");
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return result.out + result.err;
    };
    const std::string bump = said("bump-mapping.xml", "--pinhole");
    EXPECT_NE(bump.find("T1 is not done yet: "), std::string::npos) << bump;
    EXPECT_EQ(bump.find("T2."), std::string::npos) << bump;

    const std::string distributed = said("distributed.xml", "--pinhole");
    EXPECT_NE(distributed.find("T2.1 is not done yet: "), std::string::npos) << distributed;
    EXPECT_NE(distributed.find("T2.2 is not done yet: "), std::string::npos) << distributed;
    EXPECT_EQ(distributed.find("T1 "), std::string::npos) << distributed;

    EXPECT_EQ(said("bump-mapping.xml", "--quiet"), "");
}

// One ray from the eye and one to the centre of the light: no randomness.
TEST_F(Tick1Star, RendersWithoutLensAndWithHardShadowsWhereAskedTo) {
    const std::string first = render("bump-mapping.xml", {"--pinhole"});
    EXPECT_EQ(render("bump-mapping.xml", {"--pinhole", "--seed", "8"}), first);
    EXPECT_NE(render("bump-mapping.xml", {}), first);
}

TEST_F(Tick1Star, SaysItsVersionAndItsOptions) {
    const ProgramResult version = run({"--version"});
    EXPECT_EQ(version.exitCode, 0);
    EXPECT_EQ(version.out, "tick1star " TICKER_VERSION "\n");

    const ProgramResult help = run({"--help"});
    EXPECT_EQ(help.exitCode, 0);
    for (const std::string option : {"-i, --input SCENE", "--seed S", "--linear FILE", "130"})
        EXPECT_NE(help.out.find(option), std::string::npos) << option;
}

TEST_F(Tick1Star, ExplainsWrongUsage) {
    struct Usage {
        std::vector<std::string> arguments;
        std::string expected;
    };
    const std::string scene = kSceneFiles + "lens-grid.xml";
    const std::string image = file("a.png");
    const std::vector<Usage> wrong{
        {{}, "no scene given; add -i SCENE"},
        {{"-i", scene}, "add -o IMAGE"},
        {{"-i"}, "-i needs a value: SCENE"},
        {{"-i", scene, "-o", file("a.jpg")}, "a name that ends in .png"},
        {{"-i", scene, "-o", file("no/a.png")}, "does not exist; make it first"},
        {{"-i", file("no.xml"), "-o", image}, "there is no such file"},
        {{"-i", kSceneFiles + "lens-gird.xml", "-o", image}, "did you mean lens-grid.xml?"},
        {{"-i", kSceneFiles + "bump-mappin.xml", "-o", image}, "did you mean bump-mapping.xml?"},
        {{"--sed", "1"}, "did you mean --seed?"},
        {{"extra"}, "unknown option \"extra\""},
        {{"--quiet=yes"}, "takes no value"},
        {{"-i", scene, "-o", image, "-r", "640"}, "WIDTHxHEIGHT"},
        {{"-i", scene, "-o", image, "-r", "0x480"}, "a whole number from 1"},
        {{"-i", scene, "-o", image, "-r", "16000x16000"}, "64 million"},
        {{"-i", scene, "-o", image, "--seed", "-1"}, "--seed: found \"-1\", expected"},
        {{"-i", scene, "-o", image, "--threads", "0"}, "from 1 to"},
        {{"-i", scene, "-o", image, "-b", "1e9"}, "from 0 to 100"},
        {{"-i", scene, "-o", image, "--region", "1,2,3"}, "X,Y,WIDTH,HEIGHT"},
        {{"-i", scene, "-o", image, "--region", "0,0,641,480"}, "beyond the full frame"},
        {{"-i", scene, "-o", image, "--aperture", "nan"}, "a number from 0"},
        {{"-i", scene, "-o", image, "--focal-plane", "0"}, "a number above 0"},
        {{"-i", scene, "-o", image, "--assets", file("no")}, "no such folder"},
    };
    for (const Usage& usage : wrong) {
        const ProgramResult result = run(usage.arguments);
        EXPECT_EQ(result.exitCode, 2) << usage.expected;
        EXPECT_NE(result.err.find(usage.expected), std::string::npos) << result.err;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
        EXPECT_EQ(result.out, "");
    }
}

std::vector<std::string> longRender(const std::string& image) {
    // Some 30 ms for each of 480 rows, so that a signal after the first one comes in time.
    return {"-i",         kSceneFiles + "distributed.xml",
            "-o",         image,
            "-r",         "64x480",
            "--threads",  "1",
            "--dof-rays", "500",
            "--seed",     "7"};
}

TEST_F(Tick1Star, KeepsTheRowsSoFarWhenItIsInterrupted) {
    testing::Tick1StarOnTerminal program(longRender(file("a.png")), {});
    const std::string progress = program.read();  // comes with the first row
    program.interrupt();
    const int exitCode = program.wait();

    EXPECT_NE(progress.find(" left"), std::string::npos) << progress;
    EXPECT_EQ(exitCode, 130);
    const ByteImage picture = readImage(file("a.png"));
    ASSERT_EQ(picture.width, 64);
    ASSERT_EQ(picture.height, 480);
    const auto rowEnd = picture.rgb.begin() + 64 * 3;
    EXPECT_EQ(std::count(picture.rgb.begin(), rowEnd, 0), 0) << "the first row is missing";
    EXPECT_EQ(std::count(picture.rgb.end() - 64 * 3, picture.rgb.end(), 0), 64 * 3);
}

TEST_F(Tick1Star, DrawsNoProgressBarWhereColourIsUnwanted) {
    testing::Tick1StarOnTerminal program(
        {"-i", kSceneFiles + "lens-grid.xml", "-o", file("a.png"), "-r", "16x12"}, {"NO_COLOR=1"});

    EXPECT_EQ(program.read(), "");
    EXPECT_EQ(program.wait(), 0);
}

}  // namespace
}  // namespace ticker
