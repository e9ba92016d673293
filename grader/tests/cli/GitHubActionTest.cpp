// The action's script in a repository as GitHub checks it out; no runner is needed.
#include <grader/tests/support/Files.h>
#include <grader/tests/support/RunCommand.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace ticker::cli {
namespace {

class GitHubAction : public testing::Test {
protected:
    /// A repository whose folder "tick" holds a student's package with the files of a sample.
    void commit(const std::string& sample) {
        const auto from = std::filesystem::path{TICKER_SOURCE_DIR} / "grader/corpus/samples";
        std::filesystem::create_directories(folder_.path() / "tick/exercise");
        std::filesystem::copy(from / sample / "BumpySphere.cpp", folder_.path() / "tick/exercise");
        std::filesystem::copy(from / sample / "screenshot.png", folder_.path() / "tick");
    }
    [[nodiscard]] tests::CommandResult run(const std::string& settings) const {
        return tests::runCommand("cd '" + folder_.path().string() +
                                 "' && GITHUB_OUTPUT=output GITHUB_STEP_SUMMARY=summary "
                                 "TICKER_PATH=./tick TICKER=" TICKER_BINARY_DIR "/bin/ticker " +
                                 settings +
                                 " " TICKER_SOURCE_DIR "/grader/integrations/github/grade");
    }
    [[nodiscard]] std::string written(const std::string& name) const {
        return tests::runCommand("cat '" + (folder_.path() / name).string() + "'").output;
    }

    tests::TemporaryFolder folder_;
};

TEST_F(GitHubAction, AnnotatesTheCompilersLineAndTheTasksFirstLine) {
    commit("notAwarded/does-not-compile");
    const tests::CommandResult ran = run("");
    EXPECT_EQ(ran.status, 1) << ran.output;
    for (const char* part :
         {"::error file=tick/exercise/BumpySphere.cpp,line=34,title=The compiler",
          "::error file=tick/exercise/BumpySphere.cpp,line=12,title=T1 Bump"})
        EXPECT_NE(ran.output.find(part), std::string::npos) << part << "\n" << ran.output;
    EXPECT_EQ(written("output"), "verdict=notAwarded\n");
    EXPECT_TRUE(written("summary").starts_with("<pre>\n"));
    EXPECT_EQ(run("TICKER_STRICT=false").status, 0);
}

TEST_F(GitHubAction, SaysThatNothingWasAttemptedWithoutAnAnnotation) {
    commit("notAwarded/template-untouched");
    const tests::CommandResult ran = run("");
    EXPECT_EQ(ran.status, 1) << ran.output;
    EXPECT_EQ(ran.output, "");
}

TEST_F(GitHubAction, AsksAboutTwoScreenshotsThatDiffer) {
    commit("awarded/reference-bump");
    std::filesystem::copy(std::filesystem::path{TICKER_SOURCE_DIR} /
                              "grader/corpus/samples/awarded/reference-distributed/screenshot.png",
                          folder_.path() / "tick/exercise");
    const tests::CommandResult ran = run("");
    EXPECT_EQ(ran.status, 1) << ran.output;
    EXPECT_EQ(written("output"), "verdict=needsReview\n");
    std::filesystem::remove(folder_.path() / "tick/exercise/screenshot.png");
    EXPECT_EQ(run("").status, 0);
}

}  // namespace
}  // namespace ticker::cli
