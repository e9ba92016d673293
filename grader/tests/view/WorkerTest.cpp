#include "FakeKit.h"

#include <raytracer/image/ColourRGB.h>
#include <student_template/framework/app/view/Lines.h>
#include <student_template/framework/app/view/process/Process.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace raytracer::view {
namespace {

using Json = nlohmann::json;

constexpr int kWidth = 48;
constexpr int kHeight = 32;

/// A worker that runs the reference solution, and the viewer's end of its pipes.
class WorkerTest : public testing::Test {
protected:
    struct Answer {
        std::string kind;
        std::string number;
        std::string payload;
    };

    void tell(const std::string& command) { EXPECT_TRUE(process_.write(command + "\n")); }

    [[nodiscard]] Answer hear() {
        const std::vector<std::string> head = splitAt(lines_.next().value_or(""), ' ');
        if (head.size() != 3) return {};
        return {head[0], head[1], lines_.block(std::stoul(head[2])).value_or("")};
    }
    [[nodiscard]] Answer ask(const std::string& command) {
        tell(command);
        return hear();
    }

    /// The options that the viewer hands on, each after a tab.
    [[nodiscard]] std::string options(const std::string& scene, int width = kWidth,
                                      int height = kHeight) const {
        return "\t--view\t--input\t" + (kit_.folder() / "scenes" / scene).string() +
               "\t--resolution\t" + std::to_string(width) + "x" + std::to_string(height) +
               "\t--dof-rays\t4\t--seed\t7";
    }

    /// Lets the worker's input end. @return The worker's exit status.
    [[nodiscard]] int end() {
        tell("end");
        return process_.wait();
    }

    FakeKit kit_;
    std::filesystem::path room_ = kit_.write("scenes/room.xml", kBallOverFloor);

private:
    // sed ends the worker's input, which a `Process` keeps open.
    Process process_{
        {"/bin/sh", "-c", "sed -u -n '/^end$/q;p' | '" + thisProgram() + "' --view-worker"},
        Process::Errors::toOurs};
    LineReader lines_{[this](char* bytes, std::size_t size) { return process_.read(bytes, size); }};
};

/// The colour of a pixel in the payload of a whole picture: "#12AB00".
std::string pixelIn(const std::string& payload, int x, int y) {
    const std::string rgb = payload.substr(payload.find('\n') + 1);
    std::string text = "#";
    for (int i = 0; i < 3; ++i) {
        constexpr const char* kDigits = "0123456789ABCDEF";
        const auto at = static_cast<std::size_t>(3 * (y * kWidth + x) + i);
        const auto byte = static_cast<unsigned char>(rgb.at(at));
        text += {kDigits[byte / 16], kDigits[byte % 16]};
    }
    return text;
}

TEST_F(WorkerTest, DrawsThePixelThatTheWholePictureShows) {
    const Answer whole = ask("whole\t11" + options("room.xml"));
    EXPECT_EQ(whole.kind, "part");
    EXPECT_EQ(whole.number, "11");
    EXPECT_EQ(whole.payload.substr(0, whole.payload.find('\n')), "0 0 48 32 48 32 1 0.000000 ");
    ASSERT_EQ(whole.payload.size() - whole.payload.find('\n') - 1,
              static_cast<std::size_t>(3 * kWidth * kHeight));

    const Answer pixel = ask("pixel\t12\t24\t12" + options("room.xml"));
    EXPECT_EQ(pixel.kind, "drawing");
    EXPECT_EQ(pixel.number, "12");
    const Json drawing = Json::parse(pixel.payload);
    EXPECT_EQ(drawing["about"], "Pixel (24, 12) of 48 x 32");
    const std::string words = drawing["words"][0];
    EXPECT_NE(words.find("in the picture " + pixelIn(whole.payload, 24, 12)), std::string::npos)
        << words;
    const std::string ray = drawing["rays"][0]["t"];
    EXPECT_EQ(ray.find("camera ray 1 meets sphere 1 at "), 0U) << ray;
    EXPECT_EQ(end(), 0);
}

TEST_F(WorkerTest, AsksTheSurfaceThatLiesNearestToAPoint) {
    const auto aboutOf = [&](const std::string& point) {
        const Answer answer = ask("point\t5\t" + point + options("room.xml"));
        EXPECT_EQ(answer.kind, "drawing") << answer.payload;
        return Json::parse(answer.payload)["about"];
    };
    EXPECT_EQ(aboutOf("0\t0\t0"), "The point (0, -1, 0) of plane 1");
    EXPECT_EQ(aboutOf("0\t0\t2.5"), "The point (0, 0, 3) of sphere 1");
    EXPECT_EQ(end(), 0);
}

TEST_F(WorkerTest, SendsAPictureInPartsThatEndWithTheWholeOfIt) {
    const std::string whole = ask("whole\t11" + options("room.xml")).payload;
    tell("picture\t1" + options("room.xml"));
    Answer part = hear();
    EXPECT_EQ(part.payload.substr(0, part.payload.find('\n')),
              "0 0 48 32 12 8 0 0.000000 1 of 4 rays");
    part = hear();
    EXPECT_EQ(part.kind, "part");
    EXPECT_EQ(part.number, "1");
    EXPECT_EQ(part.payload, whole);
    EXPECT_EQ(end(), 0);
}

TEST_F(WorkerTest, GivesUpAPictureWhenAnotherIsWanted) {
    tell("picture\t1" + options("room.xml", 2000, 2000));  // hundreds of tiles
    EXPECT_EQ(hear().number, "1");
    tell("picture\t2" + options("room.xml"));
    Answer part = hear();
    for (; part.number == "1"; part = hear()) {
        constexpr std::size_t kIsLast = 6;
        ASSERT_EQ(splitAt(part.payload.substr(0, 80), ' ').at(kIsLast), "0");
    }
    EXPECT_EQ(part.number, "2");
    part = hear();
    EXPECT_EQ(part.number, "2");
    EXPECT_EQ(end(), 0);
}

TEST_F(WorkerTest, SaysWhatCannotBeDoneAndGoesOn) {
    const auto wordsOf = [&](const std::string& command) {
        const Answer answer = ask(command);
        EXPECT_EQ(answer.kind, "failed") << command;
        return answer.number + ": " + answer.payload;
    };
    EXPECT_EQ(wordsOf("pixel\t3\t1"), "3: a number is missing");
    EXPECT_EQ(wordsOf("point\t4\t0\t0"), "4: a number is missing");
    EXPECT_NE(wordsOf("whole\t5" + options("missing.xml")).find("missing.xml"), std::string::npos);
    EXPECT_NE(wordsOf("picture\t6" + options("missing.xml")).find("missing.xml"),
              std::string::npos);
    EXPECT_EQ(wordsOf("whole").substr(0, 2), ": ");
    EXPECT_EQ(ask("point\t7\t0\t0\t0" + options("room.xml")).kind, "drawing");
    EXPECT_EQ(end(), 0);
}

}  // namespace
}  // namespace raytracer::view
