#include <grader/intake/CanvasName.h>
#include <grader/intake/Intake.h>
#include <grader/tests/support/MoodleExport.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ticker::intake {
namespace {

namespace fs = std::filesystem;
using tests::NamedBytes;

TEST(CanvasName, HoldsTheUserAndTheFile) {
    const auto name = readCanvasName("leeann_4711_90210_BumpySphere.cpp");
    ASSERT_TRUE(name);
    EXPECT_EQ(name->owner, "leeann_4711");
    EXPECT_EQ(name->file, "BumpySphere.cpp");
    const auto late = readCanvasName("o-neilljr_late_4711_90210_my_1_2_work.zip");
    ASSERT_TRUE(late);
    EXPECT_EQ(late->owner, "o-neilljr_4711");
    EXPECT_EQ(late->file, "my_1_2_work.zip");
}

TEST(CanvasName, IsNoNameThatPeopleMakeUp) {
    for (const char* name :
         {"smith_17_2024_tick.zip", "group_1_02_tick.zip", "Ann_4711_90210_tick.zip",
          "lee_4711_90210_work", "a/lee_4711_90210_x.cpp", "_4711_90210_x.cpp", "4711_90210_x.cpp",
          "lee_4711_BumpySphere.cpp", "BumpySphere.cpp", ""})
        EXPECT_FALSE(readCanvasName(name)) << name;
}

std::map<std::string, Submission> readAll(const std::vector<NamedBytes>& members, bool unpacked) {
    const tests::TemporaryFolder folder;
    const fs::path place = folder.path() / (unpacked ? "submissions" : "submissions.zip");
    if (unpacked)
        tests::writeFolder(place, members);
    else
        tests::writeZip(place, members);
    std::map<std::string, Submission> read;
    for (const Located& located : findSubmissions(place))
        read[located.name] = readSubmission(located);
    return read;
}

TEST(CanvasExport, IsGroupedByUserAsAZipAndUnpacked) {
    for (const bool unpacked : {false, true}) {
        auto read = readAll({{"leeann_4711_90210_BumpySphere-1.cpp", "ann"},
                             {"leeann_4711_90211_screenshot.png", "p"},
                             {"leeann_4712_90301_Renderer.cpp", "another of this name"},
                             {"kimbo_late_99_90305_Renderer.cpp", "bo"},
                             {"kimbo_late_99_90306_notes.pdf", "n"}},
                            unpacked);
        ASSERT_EQ(read.size(), 3U);
        EXPECT_EQ(read["leeann_4711"].part("BumpySphere.cpp"), "ann");
        EXPECT_EQ(read["leeann_4711"].part("screenshot.png"), "p");
        EXPECT_EQ(read["leeann_4712"].part("Renderer.cpp"), "another of this name");
        EXPECT_EQ(read["kimbo_99"].part("Renderer.cpp"), "bo");
        EXPECT_EQ(read["kimbo_99"].ignored, std::vector<std::string>{"notes.pdf"});
    }
}

TEST(CanvasExport, OneSuchNameAmongOrdinaryFilesMakesNoExport) {
    auto read = readAll({{"BumpySphere.cpp", "a"}, {"lee_4711_90210_screenshot.png", "p"}}, true);
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(read.begin()->second.part("BumpySphere.cpp"), "a");
}

}  // namespace
}  // namespace ticker::intake
