#include <student_template/framework/app/Options.h>
#include <student_template/framework/app/Progress.h>
#include <student_template/framework/app/ProgressText.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <csignal>
#include <string>
#include <vector>

namespace raytracer {
namespace {

Options parse(const std::vector<std::string>& arguments) {
    return parseOptions(arguments);
}

TEST(ParseOptions, GivesTheHandoutsConstantsWhereNothingIsSaid) {
    const Options options = parse({"-i", "a.xml", "-o", "a.png"});
    const RenderSettings usual;

    EXPECT_EQ(options.scene, "a.xml");
    EXPECT_EQ(options.image, "a.png");
    EXPECT_EQ(options.settings.width, usual.width);
    EXPECT_EQ(options.settings.bounces, usual.bounces);
    EXPECT_EQ(options.settings.dofRayCount, usual.dofRayCount);
    EXPECT_TRUE(options.settings.region.isWholeFrame());
    EXPECT_FALSE(options.seed);
    EXPECT_FALSE(options.threads);
}

TEST(ParseOptions, ReadsEveryOption) {
    const Options options = parse({"--input=a.xml",
                                   "--output",
                                   "a.PNG",
                                   "-r",
                                   "320x240",
                                   "-b",
                                   "5",
                                   "--seed",
                                   "9",
                                   "--threads",
                                   "3",
                                   "--region",
                                   "1,2,30,40",
                                   "--shadow-rays",
                                   "6",
                                   "--light-size",
                                   "0.7",
                                   "--dof-rays",
                                   "8",
                                   "--aperture",
                                   "0",
                                   "--focal-plane",
                                   "4.5",
                                   "--assets",
                                   "maps",
                                   "--linear",
                                   "a.pfm",
                                   "-q",
                                   "-v"});
    const RenderSettings& settings = options.settings;

    EXPECT_EQ(settings.width, 320);
    EXPECT_EQ(settings.height, 240);
    EXPECT_EQ(settings.bounces, 5);
    EXPECT_EQ(options.seed, 9U);
    EXPECT_EQ(options.threads, 3);
    EXPECT_EQ(settings.region.x, 1);
    EXPECT_EQ(settings.region.y, 2);
    EXPECT_EQ(settings.region.width, 30);
    EXPECT_EQ(settings.region.height, 40);
    EXPECT_EQ(settings.shadowRayCount, 6);
    EXPECT_EQ(settings.lightSize, 0.7);
    EXPECT_EQ(settings.dofRayCount, 8);
    EXPECT_EQ(settings.dofAmount, 0.0);
    EXPECT_EQ(settings.dofFocalPlane, 4.5);
    EXPECT_EQ(options.assets, "maps");
    EXPECT_EQ(options.linear, "a.pfm");
    EXPECT_TRUE(options.quiet);
    EXPECT_TRUE(options.verbose);
}

TEST(ProgressText, SaysShareAndTimeLeft) {
    EXPECT_EQ(progressText(1, 4, 10.0), "[#######-----------------------]  25 %, 30 s left");
    EXPECT_EQ(progressText(240, 480, 95.0),
              "[###############---------------]  50 %, 1 min 35 s left");
    EXPECT_EQ(progressText(1, 2, 7260.0), "[###############---------------]  50 %, 2 h 1 min left");
    EXPECT_EQ(progressText(4, 4, 1.0), "[##############################] 100 %, 0 s left");
}

TEST(Progress, HeedsTheInterruptAndForgetsItAfterwards) {
    {
        Progress progress{false};
        progress.rowFinished(0, 1, 2);
        EXPECT_FALSE(progress.interrupted());
        EXPECT_EQ(std::raise(SIGINT), 0);
        EXPECT_TRUE(progress.interrupted());
        EXPECT_EQ(progress.done(), 1);
    }
    EXPECT_FALSE(Progress{false}.interrupted());
}

}  // namespace
}  // namespace raytracer
