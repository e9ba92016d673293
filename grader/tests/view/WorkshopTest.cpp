#include "FakeKit.h"

#include <student_template/framework/app/view/Workshop.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <thread>

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

Json failedBuildOf(Board& board) {
    const Json all = waitFor(board, [](const Json& news) {
        return news.contains("build") && news["build"]["state"] == "failed";
    });
    return all.is_null() ? all : all["build"];
}

TEST(Workshop, ShowsTheFirstErrorWithItsLine) {
    // A compiler names files from its build folder, or in full.
    for (const bool isInFull : {false, true}) {
        FakeKit kit;
        kit.write("exercise/Renderer.cpp", "int a;\nint b\n");
        const std::string file =
            (isInFull ? kit.folder() / "exercise" : "exercise") / "Renderer.cpp";
        kit.script("cmake", "echo begun; echo \"" + file + ":2:6: error: expected ';'\"; exit 1");
        int unchanged = 0;
        Board board;
        Json build;
        {
            const Workshop workshop{kit.home(), board, {[] {}, [] {}, [&] { ++unchanged; }}};
            build = failedBuildOf(board);
        }
        EXPECT_EQ(build["file"], "Renderer.cpp");
        EXPECT_EQ(build["line"], 2);
        EXPECT_EQ(build["message"], "expected ';'");
        EXPECT_EQ(build["source"], "int b");
        EXPECT_EQ(build["all"], "begun\n" + file + ":2:6: error: expected ';'\n");
        EXPECT_EQ(unchanged, 1);
    }
}

TEST(Workshop, ShowsTheBeginningOfTooMuchOfACompiler) {
    FakeKit kit;
    kit.script("cmake", "echo the first error; yes 'and its notes' | head -n 30000; exit 1");
    Board board;
    const Workshop workshop{kit.home(), board, nobody()};
    const std::string all = failedBuildOf(board)["all"];
    EXPECT_EQ(all.size(), 20'000U);
    EXPECT_EQ(all.find("the first error\nand its notes\n"), 0U);
}

TEST(Workshop, ShowsTheEndOfTooMuchOfATestThatCrashes) {
    FakeKit kit;
    kit.script("tests", std::string{kOnlyShadows} +
                            "yes 'a line of my own' | head -n 100000; echo the end; kill -SEGV $$");
    Board board;
    const Workshop workshop{kit.home(), board, nobody()};
    const std::string text = testsOf(board)["text"];
    EXPECT_EQ(text.size(), 20'000U);
    EXPECT_TRUE(text.ends_with("a line of my own\nthe end\n"));
}

TEST(Workshop, TellsWhereTheTestsDoNotCompile) {
    FakeKit kit;
    kit.script("cmake",
               "case $4 in tests) echo 'T.cpp:3:1: error: no such function'; exit 1;; esac");
    Board board;
    const Workshop workshop{kit.home(), board, nobody()};
    const Json tests = testsOf(board);
    ASSERT_FALSE(tests.is_null());
    EXPECT_EQ(tests["state"], "unbuilt");
    EXPECT_EQ(tests["message"], "no such function");
    EXPECT_EQ(tests["source"], "");  // there is no such file
    EXPECT_EQ(Json::parse(board.newsAfter(0))["build"]["state"], "built");
}

TEST(Workshop, ForgetsTheTestsOfCodeThatNoLongerCompiles) {
    FakeKit kit;
    Board board;
    Workshop workshop{kit.home(), board, nobody()};
    EXPECT_EQ(testsOf(board)["state"], "passed");
    kit.script("cmake", "exit 1");
    kit.write("exercise/Renderer.cpp", "int saved");
    workshop.look();
    EXPECT_EQ(failedBuildOf(board)["state"], "failed");
    EXPECT_EQ(Json::parse(board.newsAfter(0))["tests"]["state"], "unasked");
}

TEST(Workshop, SaysThatTheSystemGivesNoProcess) {
    const FakeKit kit;
    Board board;
    const FewFiles few;
    const Workshop workshop{kit.home(), board, nobody()};
    const Json all = waitFor(board, [](const Json& news) {
        return news.contains("build") && news["build"]["state"] == "failed";
    });
    ASSERT_FALSE(all.is_null());
    EXPECT_EQ(all["build"]["all"], "the system gives no pipe");
}

TEST(Workshop, SaysThatThereAreNoTests) {
    FakeKit kit;
    kit.home().testTarget.clear();
    Board board;
    const Workshop workshop{kit.home(), board, nobody()};
    EXPECT_EQ(testsOf(board)["state"], "none");
}

TEST(Workshop, BeginsAgainWhereAFileIsSavedDuringABuild) {
    FakeKit kit;
    // The first build never ends by itself.
    kit.script("cmake", "cd '" + kit.folder().string() +
                            "' && mkdir first 2>/dev/null || exit 0\n" + "exec tail -f /dev/null");
    int saves = 0;
    int built = 0;
    Board board;
    {
        Workshop workshop{kit.home(), board, {[&] { ++saves; }, [] {}, [&] { ++built; }}};
        EXPECT_FALSE(
            waitFor(board, [](const Json& news) { return news.contains("build"); }).is_null());
        while (!std::filesystem::exists(kit.folder() / "first"))
            std::this_thread::yield();
        kit.write("exercise/Renderer.cpp", "int saved;");
        workshop.look();
        EXPECT_EQ(testsOf(board)["state"], "passed");
    }
    EXPECT_EQ(saves, 1);
    EXPECT_EQ(built, 1);
}

TEST(Workshop, EndsABuildThatRuns) {
    FakeKit kit;
    kit.script("cmake", "exec tail -f /dev/null");
    Board board;
    {
        const Workshop workshop{kit.home(), board, nobody()};
        EXPECT_FALSE(
            waitFor(board, [](const Json& news) { return news.contains("build"); }).is_null());
    }
    EXPECT_EQ(Json::parse(board.newsAfter(0))["build"]["state"], "building");
}

}  // namespace
}  // namespace raytracer::view
