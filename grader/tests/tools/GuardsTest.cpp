#include <grader/tests/support/RunCommand.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <string>

namespace ticker {
namespace {

using tests::CommandResult;

/// A repository with guards of its own.
class Guards : public testing::Test {
protected:
    [[nodiscard]] CommandResult runWith(const std::string& table,
                                        const std::string& environment = "") const {
        folder_.write("tools/guards/guards.tsv",
                      "# name\tcommand\tfigure\tignores\tleft out\n" + table);
        return runIn(
            "git add -A && git -c user.name=t -c user.email=t@example.org commit -qm all; " +
            environment + " tools/guards/guards 2>/dev/null");
    }
    [[nodiscard]] CommandResult runIn(const std::string& command) const {
        return tests::runCommand("cd '" + folder_.path().string() + "' && " + command);
    }

    void SetUp() override {
        const CommandResult made = runIn(
            "git init -q && mkdir -p tools/guards && echo build/ > .gitignore && cp "
            "'" TICKER_SOURCE_DIR "/tools/guards/guards' tools/guards/");
        ASSERT_EQ(made.status, 0) << made.output;
    }

    tests::TemporaryFolder folder_;
};

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST_F(Guards, PrintOneTableWithFiguresAndWhatIsLeftOut) {
    const CommandResult ran = runWith(
        "count\techo 17 tests passed\t[0-9]+ tests\t-\tthe rest\n"
        "look\ttrue\t-\t-\tnothing\n");
    EXPECT_EQ(ran.status, 0) << ran.output;
    EXPECT_TRUE(has(ran.output, "| count | ") && has(ran.output, "| 17 tests | the rest |"))
        << ran.output;
    EXPECT_TRUE(has(ran.output, "| look | ") && has(ran.output, "Z | passed | ")) << ran.output;
}

TEST_F(Guards, GoOnAfterAFailureAndReportIt) {
    const CommandResult ran = runWith("bad\texit 3\t-\t-\tnothing\ngood\ttrue\t-\t-\tnothing\n");
    EXPECT_EQ(ran.status, 1);
    EXPECT_TRUE(has(ran.output, "failed (3)")) << ran.output;
    EXPECT_TRUE(has(ran.output, "| good | ")) << ran.output;
}

TEST_F(Guards, ThatPassedOnThisCommitAreNotRunAgain) {
    const std::string table = "count\techo x >> build/times\t-\t-\tnothing\n";
    EXPECT_EQ(runWith(table).status, 0);
    EXPECT_EQ(runWith(table).status, 0);
    EXPECT_EQ(runIn("wc -l < build/times").output, "1\n");
    folder_.write("other", "a change");
    EXPECT_EQ(runWith(table).status, 0);
    EXPECT_EQ(runIn("wc -l < build/times").output, "2\n") << "another commit";
}

TEST_F(Guards, ThatIgnoreDocumentsAreNotRunAgainAfterAChangeOfOne) {
    const std::string table = "count\techo x >> build/times\t-\t*.md\tnothing\n";
    EXPECT_EQ(runWith(table).status, 0);
    folder_.write("docs/notes.md", "a change");
    const CommandResult kept = runWith(table);
    EXPECT_EQ(kept.status, 0);
    EXPECT_TRUE(has(kept.output, "| count | ")) << kept.output;
    EXPECT_EQ(runIn("wc -l < build/times").output, "1\n");
    folder_.write("docs/notes.cpp", "a change");
    EXPECT_EQ(runWith(table).status, 0);
    EXPECT_EQ(runIn("wc -l < build/times").output, "2\n") << "not a document";
}

TEST_F(Guards, AreNotRunAgainOnAnotherMachineThatHasTheRecord) {
    const std::string table = "count\techo x >> times\t-\t-\tnothing\n";
    folder_.write(".gitignore", "build/\ntimes\n");
    EXPECT_EQ(runWith(table).status, 0);
    const CommandResult kept = runIn("rm -r build && git status --porcelain");
    EXPECT_EQ(kept.output, "?? tools/guards/record.tsv\n");
    EXPECT_EQ(runWith(table).status, 0) << "commits the record";
    EXPECT_EQ(runIn("wc -l < times").output, "1\n");
}

TEST_F(Guards, KeepOneRowOfEach) {
    EXPECT_EQ(runWith("a\techo 1 test\t[0-9] test\t-\tnothing\n"
                      "b\ttrue\t-\t-\tnothing\n")
                  .status,
              0);
    EXPECT_EQ(runWith("a\techo 2 test\t[0-9] test\t-\tnothing\n").status, 0);
    EXPECT_EQ(runIn("cut -f1,3,6 tools/guards/record.tsv").output,
              "b\tpassed\t\na\tpassed\t2 test\n");
}

TEST_F(Guards, RunAgainWithAFileThatIsNotYetAdded) {
    const std::string table = "count\techo x >> build/times\t-\t-\tnothing\n";
    EXPECT_EQ(runWith(table).status, 0);
    folder_.write("new.cpp", "a new test");
    const CommandResult again = runIn("tools/guards/guards 2>/dev/null");
    EXPECT_EQ(runIn("wc -l < build/times").output, "2\n");
    EXPECT_TRUE(has(again.output, " and changes |")) << again.output;
}

TEST_F(Guards, EndWithTheGuardThatRuns) {
    folder_.write("tools/guards/guards.tsv",
                  "first\techo $$ > build/started; sleep 300\t-\t-\tnothing\n"
                  "second\ttouch build/went-on\t-\t-\tnothing\n");
    const CommandResult ran = runIn(
        "git add -A; git -c user.name=t -c user.email=t@example.org commit -qm all; "
        "tools/guards/guards >/dev/null 2>&1 & pid=$!; "
        "until [ -s build/started ]; do :; done; kill $pid; wait $pid; echo $?; "
        "tail --pid=$(cat build/started) -f /dev/null; ls build");
    EXPECT_EQ(ran.output, "130\nguards\nstarted\n");
}

TEST(House, CountsNothingWhereNothingNamesATask) {
    const tests::TemporaryFolder folder;
    folder.write("tools/guards/guards.tsv", "");
    folder.write("tick", "");
    folder.write("CMakeLists.txt", "");
    folder.write("cmake/a.cmake", "");
    folder.write("student_template/a.cpp", "");
    folder.write("reference_solution/a.cpp", "");
    folder.write("grader/a.cpp", "");
    folder.write("grader/result/GeneralFindings.h", "\"x.y\"\n");
    folder.write("grader/tasks/bump/BumpFindings.h", "\"bump.flat\"\n");
    folder.write("grader/exercises/one/exercise.json",
                 "{\"id\": \"T1\", \"name\": \"A\", \"tasks\": [],\n"
                 "\"file\": \"BumpySphere.cpp\",\n\"name\": \"bump\", \"file\": \"\"}\n");
    const CommandResult ran = tests::runCommand("cd '" + folder.path().string() +
                                                "' && cp '" TICKER_SOURCE_DIR
                                                "/tools/guards/house' tools/guards/ && "
                                                "tools/guards/house -v");
    EXPECT_EQ(ran.status, 0) << ran.output;
    EXPECT_TRUE(has(ran.output, "of these, in a folder that a submission passes")) << ran.output;
}

TEST_F(Guards, RefuseANameThatTheTableLacks) {
    folder_.write("tools/guards/guards.tsv", "good\ttrue\t-\t-\tnothing\n");
    const CommandResult ran = runIn(
        "git add -A; git -c user.name=t -c user.email=t@example.org "
        "commit -qm all; tools/guards/guards bad");
    EXPECT_EQ(ran.status, 2);
    EXPECT_TRUE(has(ran.output, "there is no guard 'bad'")) << ran.output;
}

}  // namespace
}  // namespace ticker
