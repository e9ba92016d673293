// Output of tick1star besides its picture: preview, trace, normals, comparison.
#include "StudentProgram.h"

#include <raytracer/io/ImageReader.h>

#include <grader/tests/io/BytesOf.h>
#include <grader/tests/support/TemporaryFolder.h>
#include <tools/terminal_picture/TerminalPicture.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
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

const std::string kScenes = std::string(TICKER_SOURCE_DIR) + "/scenes/";

class Tick1StarShows : public ::testing::Test {
protected:
    [[nodiscard]] std::string file(const std::string& name) const { return folder_.path() / name; }

    [[nodiscard]] ProgramResult run(const std::vector<std::string>& arguments) const {
        return testing::runTick1Star(arguments, folder_.path());
    }

    /// A picture of 60 x 40 pixels, so small that a terminal of 24 lines shows each of them.
    [[nodiscard]] std::vector<std::string> smallPreview() const {
        return {"-i", kScenes + "distributed.xml",
                "-o", file("a.png"),
                "-r", "60x40",
                "-p", "--seed",
                "7",  "--dof-rays",
                "4"};
    }

    TemporaryFolder folder_;
};

TEST_F(Tick1StarShows, ThePictureInTheTerminalInFullColour) {
    testing::Tick1StarOnTerminal program(smallPreview(),
                                         {"COLORTERM=truecolor", "TERM=xterm-256color"});
    const ByteImage shown = terminalPicture(program.readAll());
    ASSERT_EQ(program.wait(), 0);

    const ByteImage picture = readImage(file("a.png"));
    EXPECT_EQ(shown.width, picture.width);
    EXPECT_EQ(shown.height, picture.height);
    EXPECT_EQ(shown.rgb, picture.rgb);
}

TEST_F(Tick1StarShows, ThePictureInTheTerminalInColoursOfXterm) {
    testing::Tick1StarOnTerminal program(smallPreview(), {"COLORTERM=", "TERM=xterm-256color"});
    const std::string written = program.readAll();
    ASSERT_EQ(program.wait(), 0);

    EXPECT_EQ(written.find("38;2;"), std::string::npos);
    const ByteImage shown = terminalPicture(written);
    const ByteImage picture = readImage(file("a.png"));
    ASSERT_EQ(shown.rgb.size(), picture.rgb.size());
    for (std::size_t i = 0; i < shown.rgb.size(); ++i)
        ASSERT_NEAR(shown.rgb[i], picture.rgb[i], 48) << "byte " << i;
}

TEST_F(Tick1StarShows, LettersWhereColourIsUnwanted) {
    testing::Tick1StarOnTerminal program(smallPreview(),
                                         {"NO_COLOR=1", "COLORTERM=truecolor", "TERM=xterm"});
    const std::string written = program.readAll();
    ASSERT_EQ(program.wait(), 0);

    EXPECT_EQ(written.find("\033[38"), std::string::npos);
    EXPECT_EQ(written.find(" left"), std::string::npos) << "a progress bar";
    EXPECT_NE(written.find('#'), std::string::npos);
}

TEST_F(Tick1StarShows, NoEscapeCodesWhereThereIsNoTerminal) {
    const ProgramResult result = run(smallPreview());

    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.err.find('\033'), std::string::npos);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 20);
}

TEST_F(Tick1StarShows, ThePreviewWhileItRendersAndTheRowsSoFarWhenCtrlCIsTyped) {
    testing::Tick1StarOnTerminal program(
        {"-i", kScenes + "distributed.xml", "-o", file("a.png"), "-r", "40x400", "--threads", "1",
         "--dof-rays", "500", "-p"},
        {"COLORTERM=truecolor", "TERM=xterm"});
    std::string written = program.read();
    program.interrupt();
    written += program.readAll();

    EXPECT_EQ(program.wait(), 130);
    EXPECT_GT(terminalPicture(written).width, 0);
    const ByteImage picture = readImage(file("a.png"));
    ASSERT_EQ(picture.height, 400);
    EXPECT_GT(picture.rgb.front(), 0) << "the first row is missing";
    EXPECT_EQ(picture.rgb.back(), 0) << "the render was not stopped";
}

TEST_F(Tick1StarShows, WhatHappensAtOnePixel) {
    testing::Tick1StarOnTerminal program(
        {"-i", kScenes + "distributed.xml", "--trace", "320,300", "--seed", "7"}, {});
    const std::string told = program.readAll();

    EXPECT_EQ(program.wait(), 0);
    EXPECT_NE(told.find("pixel (320, 300) of 640x480, seed 7"), std::string::npos) << told;
    EXPECT_NE(told.find("camera ray 50 from"), std::string::npos) << told;
    EXPECT_NE(told.find("light 1: 10 shadow rays, "), std::string::npos) << told;
    EXPECT_EQ(std::filesystem::exists(file("a.png")), false);
}

TEST_F(Tick1StarShows, TheTracedPixelsColourIsThatOfThePicture) {
    const std::vector<std::string> usual{
        "-i", kScenes + "distributed.xml", "--seed", "7", "-r", "64x48", "--dof-rays", "4"};
    std::vector<std::string> tracing = usual;
    tracing.insert(tracing.end(), {"--trace", "30,40"});
    std::vector<std::string> rendering = usual;
    rendering.insert(rendering.end(), {"-o", file("a.png")});
    const ProgramResult told = run(tracing);
    ASSERT_EQ(run(rendering).exitCode, 0);

    const ByteImage picture = readImage(file("a.png"));
    const std::size_t at = 3 * (40 * 64 + 30);
    char hex[8];
    std::snprintf(hex, sizeof hex, "#%02X%02X%02X", picture.rgb[at], picture.rgb[at + 1],
                  picture.rgb[at + 2]);
    EXPECT_NE(told.out.find(hex), std::string::npos) << hex << "\n" << told.out;
}

TEST_F(Tick1StarShows, NormalsAsColours) {
    const ProgramResult result = run({"-i", kScenes + "distributed.xml", "-o", file("a.png"), "-r",
                                      "64x48", "--normals", "--quiet"});
    ASSERT_EQ(result.exitCode, 0) << result.err;

    const ByteImage picture = readImage(file("a.png"));
    // The wall faces the viewer: its normal is (0, 0, -1).
    EXPECT_EQ(picture.rgb[0], 128);
    EXPECT_EQ(picture.rgb[1], 128);
    EXPECT_EQ(picture.rgb[2], 255);
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
        double squares = 0.0;
        for (std::size_t channel = 0; channel < 3; ++channel)
            squares += std::pow((picture.rgb[i + channel] - 127.5) / 127.5, 2);
        ASSERT_NEAR(std::sqrt(squares), 1.0, 0.02) << "pixel " << i / 3;
    }
}

TEST_F(Tick1StarShows, HowFarTwoPicturesAreApart) {
    const std::vector<std::string> usual{
        "-i", kScenes + "distributed.xml", "-r", "64x48", "--dof-rays", "2", "--seed", "7"};
    std::vector<std::string> first = usual;
    first.insert(first.end(), {"-o", file("a.png")});
    ASSERT_EQ(run(first).exitCode, 0);
    std::vector<std::string> same = usual;
    same.insert(same.end(), {"-o", file("b.png"), "--compare", file("a.png")});
    std::vector<std::string> other = same;
    other.insert(other.end(), {"--seed", "8"});

    EXPECT_NE(run(same).out.find("the pictures are equal"), std::string::npos);
    const ProgramResult result = run(other);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_NE(result.out.find("mean difference "), std::string::npos) << result.out;
    EXPECT_EQ(readImage(file("b-difference.png")).width, 64);
}

TEST_F(Tick1StarShows, AnErrorIfTheOtherPictureIsMissingOrOfAnotherSize) {
    const ProgramResult missing =
        run({"-i", kScenes + "distributed.xml", "-o", file("a.png"), "--compare", file("no.png")});
    EXPECT_EQ(missing.exitCode, 2);
    EXPECT_NE(missing.err.find("no.png"), std::string::npos) << missing.err;

    const ProgramResult size =
        run({"-i", kScenes + "lens-grid.xml", "-o", file("a.png"), "-r", "8x6", "--compare",
             std::string(TICKER_SOURCE_DIR) + "/assets/bumpmap-test.png"});
    EXPECT_EQ(size.exitCode, 2);
    EXPECT_NE(size.err.find("expected 8x6"), std::string::npos) << size.err;
}

}  // namespace
}  // namespace ticker
