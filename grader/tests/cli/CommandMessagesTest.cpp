// What verbs say where they cannot do their work, and the commands that they advise.
#include <grader/tests/support/Files.h>
#include <grader/tests/support/RunCommand.h>
#include <grader/tests/support/TemporaryFolder.h>

#include "RunTicker.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

const std::string kScene = "'" TICKER_SOURCE_DIR "/scenes/bump-mapping.xml'";

class CommandMessages : public testing::Test {
protected:
    CommandMessages() { setenv("TICKER_COMMAND", "./tick", 1); }
    ~CommandMessages() override { unsetenv("TICKER_COMMAND"); }
    CommandMessages(const CommandMessages&) = delete;
    CommandMessages& operator=(const CommandMessages&) = delete;

    [[nodiscard]] Ran run(const std::string& arguments,
                          const std::string& program = "ticker") const {
        return runTicker(arguments, (folder_.path() / "errors").string(), program);
    }
    [[nodiscard]] std::string at(const std::string& path) const {
        return "'" + (folder_.path() / path).string() + "'";
    }
    void putClass() const {
        for (const char* name : {"class/ann/BumpySphere.cpp", "class/bob/BumpySphere.cpp"})
            folder_.write(name,
                          tests::readFile("grader/corpus/samples/notAwarded/template-untouched/"
                                          "BumpySphere.cpp"));
    }

    tests::TemporaryFolder folder_;
};

TEST_F(CommandMessages, AFolderThatCannotBeReadIsAnInput) {
    const std::string tooLong = at(std::string(300, 'x'));
    for (const std::string& arguments :
         {"collect " + tooLong, "explain " + tooLong, "package student -o " + tooLong + "/kit.zip",
          "refs --check --folder " + tooLong, "refs --folder " + tooLong}) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.status, 2) << arguments << ran.errors;
        EXPECT_EQ(ran.errors.find("unexpected"), std::string::npos) << ran.errors;
    }
}

TEST_F(CommandMessages, CollectSaysThatItsFolderIsNoFolder) {
    folder_.write("file", "");
    const Ran ran = run("collect " + at("file"));
    EXPECT_EQ(ran.status, 2);
    EXPECT_NE(ran.errors.find("is no folder; expected a folder with results below"),
              std::string::npos)
        << ran.errors;
    const Ran below = run("collect " + at("file/below"));
    EXPECT_EQ(below.status, 2);
    EXPECT_NE(below.errors.find("expected a folder with results below"), std::string::npos)
        << below.errors;
}

TEST_F(CommandMessages, AMistypedHomeIsNamed) {
    setenv("TICKER_HOME", folder_.path().c_str(), 1);
    const Ran ran = run("render " + kScene + " -r 8x6 -o " + at("a.png"));
    unsetenv("TICKER_HOME");
    EXPECT_EQ(ran.status, 2);
    EXPECT_EQ(ran.errors, "ticker: TICKER_HOME=" + folder_.path().string() +
                              ": has no folder scenes; expected the folder of the kit's data, or "
                              "no value\n");
}

TEST_F(CommandMessages, AnEmptyHomeIsAsNone) {
    setenv("TICKER_HOME", "", 1);
    const Ran ran = run("render " + kScene + " -r 8x6 -o " + at("a.png"));
    unsetenv("TICKER_HOME");
    EXPECT_EQ(ran.status, 0) << ran.errors;
}

TEST_F(CommandMessages, AnExerciseWithoutReferenceProgramIsToldFromOneThatIsNotBuilt) {
    const Ran ran = run("render " + kScene + " --exercise tick1 -r 8x6 -o " + at("a.png"));
    EXPECT_EQ(ran.status, 2);
    EXPECT_NE(ran.errors.find("--exercise tick1: it has no reference program; give --solution"),
              std::string::npos)
        << ran.errors;
    EXPECT_EQ(run("render " + kScene + " --exercise tick1 --engine oracle -r 8x6 -o " + at("a.png"))
                  .status,
              0);
}

// The program alone, without those that are built beside it.
TEST_F(CommandMessages, AReferenceThatIsNotBuiltIsNamedWithTheReason) {
    fs::copy(TICKER_BINARY_DIR "/bin/ticker", folder_.path());
    const tests::CommandResult ran =
        tests::runCommand("TICKER_HOME='" TICKER_SOURCE_DIR "' " + at("ticker") + " render " +
                          kScene + " -r 8x6 -o " + at("a.png"));
    EXPECT_EQ(ran.status, 3);
    EXPECT_NE(ran.output.find("tick1star-reference: No such file or directory; ./tick builds it"),
              std::string::npos)
        << ran.output;
}

TEST_F(CommandMessages, AdviceNamesTheCommandThatWasTyped) {
    putClass();
    fs::create_directory(folder_.path() / "empty");
    EXPECT_NE(run("check " + at("class")).errors.find("check takes one (./tick grade takes many)"),
              std::string::npos);
    EXPECT_NE(run("explain " + at("class"))
                  .errors.find("explain takes one (./tick grade --explain failed takes many)"),
              std::string::npos);
    EXPECT_NE(run("refs --check --folder " + at("empty"))
                  .errors.find("holds no references; ./tick refs makes them"),
              std::string::npos);
    const Ran graded = run("grade " + at("class") + " -o " + at("My Class") + " --seed 7");
    EXPECT_NE(graded.errors.find("./tick session " + at("My Class") + "\n"), std::string::npos)
        << graded.errors;
}

TEST_F(CommandMessages, DoctorNamesTheFolderOfTemporaryFiles) {
    fs::permissions(folder_.path(), fs::perms{0711});
    setenv("TMPDIR", folder_.path().c_str(), 1);
    const Ran ran = run("doctor");
    unsetenv("TMPDIR");
    EXPECT_NE(ran.output.find(" GB free for temporary files in " + folder_.path().string()),
              std::string::npos)
        << ran.output;
}

// Jobs of root have another uid.
TEST_F(CommandMessages, DoctorSaysThatTheSandboxDoesNotUseTmpdir) {
    if (geteuid() != 0) GTEST_SKIP() << "only the jobs of root have another uid";
    fs::permissions(folder_.path(), fs::perms{0700});
    setenv("TMPDIR", folder_.path().c_str(), 1);
    const Ran ran = run("doctor");
    unsetenv("TMPDIR");
    EXPECT_NE(ran.output.find(", not in TMPDIR (" + folder_.path().string() + ")"),
              std::string::npos)
        << ran.output;
}

// Other programs obey TMP, the sandbox does not.
TEST_F(CommandMessages, DoctorNamesTheDiskThatTheSandboxUses) {
    const char* const before = std::getenv("TMPDIR");
    const std::string usual = before == nullptr ? "" : before;
    unsetenv("TMPDIR");
    setenv("TMP", folder_.path().c_str(), 1);
    const Ran ran = run("doctor");
    unsetenv("TMP");
    if (before != nullptr) setenv("TMPDIR", usual.c_str(), 1);
    EXPECT_NE(ran.output.find(" for temporary files in /"), std::string::npos) << ran.output;
    EXPECT_EQ(ran.output.find(folder_.path().string()), std::string::npos) << ran.output;
}

TEST_F(CommandMessages, RepairsWritesNothingWhereNoEntryFits) {
    const fs::path document = folder_.write("repairs.md", "as it was");
    const Ran ran = run("repairs --case no-such-case --record " + at("record.jsonl") + " --write " +
                            at("repairs.md"),
                        "ticker-lab");
    EXPECT_EQ(ran.status, 2) << ran.output;
    EXPECT_NE(ran.errors.find("no entry fits --task, --case, --collection"), std::string::npos)
        << ran.errors;
    EXPECT_EQ(fs::file_size(document), std::string{"as it was"}.size());
}

}  // namespace
}  // namespace ticker::cli
