#include "FakeKit.h"

#include <student_template/framework/app/view/Workshop.h>

#include <gtest/gtest.h>

#include <string>

namespace raytracer::view {
namespace {

using Json = nlohmann::json;

constexpr const char* kOnlyShadows = "case $1 in *BumpMapping*) exit 0;; esac\n";
constexpr const char* kPassed = "echo 'T2.1 soft shadows: 11 of 11 public tests passed'";

Workshop::Listener nobody() {
    return {[] {}, [] {}, [] {}};
}

Json testsOf(Board& board) {
    const Json all = waitFor(board, [](const Json& news) {
        return news.contains("tests") && news["tests"]["state"] != "running";
    });
    return all.is_null() ? all : all["tests"];
}

TEST(Workshop, NoticesSavesAfterAFileIsDeleted) {
    FakeKit kit;
    const std::filesystem::path second = kit.write("exercise/Second.cpp", "int b;");
    kit.script("cmake", "cat '" + kit.home().exercise.string() + "/Renderer.cpp'; exit 1");
    Board board;
    Workshop workshop{kit.home(), board, nobody()};
    const auto isBuilt = [&](const std::string& text) {
        return !waitFor(board, [&](const Json& news) {
                    return news.contains("build") && news["build"].value("all", "") == text;
                }).is_null();
    };
    EXPECT_TRUE(isBuilt("// TASK T2.1 begin\n"));
    std::filesystem::remove(second);
    for (int i = 0; i < 100; ++i)
        workshop.look();

    kit.write("exercise/Renderer.cpp", "int saved;");
    workshop.look();
    EXPECT_TRUE(isBuilt("int saved;"));
}

TEST(Workshop, ToleratesAMomentWithoutTheFile) {
    FakeKit kit;
    int builds = 0;
    Board board;
    {
        Workshop workshop{kit.home(), board, {[&] { ++builds; }, [] {}, [] {}}};
        EXPECT_EQ(testsOf(board)["state"], "passed");
        const std::filesystem::path file = kit.home().exercise / "Renderer.cpp";
        std::filesystem::rename(file, kit.home().build / "kept");
        workshop.look();
        std::filesystem::rename(kit.home().build / "kept", file);
        workshop.look();
    }
    EXPECT_EQ(builds, 0);
}

TEST(Workshop, ReadsTheSummaryAfterAnyNumberOfTheStudentsOwnLines) {
    FakeKit kit;
    kit.script("tests",
               std::string{kOnlyShadows} + "yes 'a line of my own' | head -n 100000\n" + kPassed);
    Board board;
    const Workshop workshop{kit.home(), board, nobody()};
    const Json tests = testsOf(board);
    EXPECT_EQ(tests["state"], "passed") << tests;
    EXPECT_EQ(tests["summary"], "T2.1 soft shadows: 11 of 11 public tests passed\n");
}

TEST(Workshop, TellsOfTheOtherTasksWhereOneCrashes) {
    FakeKit kit;
    kit.script("tests", std::string{"case $1 in *BumpMapping*) kill -SEGV $$;; esac\n"} + kPassed);
    Board board;
    const Workshop workshop{kit.home(), board, nobody()};
    const Json tests = testsOf(board);
    EXPECT_EQ(tests["state"], "failed");
    EXPECT_EQ(tests["title"], "T1 ended too early");
    EXPECT_EQ(tests["summary"],
              "T1 ended too early\nT2.1 soft shadows: 11 of 11 public tests passed\n");
}

TEST(Workshop, AsksTheTasksOfTheSavedFileAlone) {
    FakeKit kit;
    kit.script("tests", "echo \"NOT YET: T2.1 $*\"; exit 1");
    Board board;
    Workshop workshop{kit.home(), board, nobody()};
    EXPECT_EQ(testsOf(board)["title"], "T2.1 --gtest_filter=BumpMapping.*");

    kit.write("exercise/Renderer.cpp", "// TASK T2.1 begin\nint saved;\n");
    workshop.look();
    EXPECT_FALSE(waitFor(board, [](const Json& news) {
                     return news.contains("tests") &&
                            news["tests"].value("title", "") == "T2.1 --gtest_filter=SoftShadows.*";
                 }).is_null());
}

TEST(Workshop, TellsTheFailingTestBetweenTheStudentsOwnLines) {
    FakeKit kit;
    kit.script("tests", std::string{kOnlyShadows} +
                            "yes 'a line of my own' | head -n 100000\n"
                            "yes x | head -n 9000 | tr -d '\\n'\n"
                            "printf 'NOT YET: T2.1 Shadows are "
                            "soft\\n  got:  1\\n\\n'\n"
                            "yes 'a line of my own' | head -n 100000\n"
                            "echo 'T2.1 soft shadows: 10 of 11 public tests passed'; exit 1");
    Board board;
    const Workshop workshop{kit.home(), board, nobody()};
    const Json tests = testsOf(board);
    EXPECT_EQ(tests["state"], "failed");
    EXPECT_EQ(tests["title"], "T2.1 Shadows are soft");
    EXPECT_EQ(tests["text"], "  got:  1\n");
}

}  // namespace
}  // namespace raytracer::view
