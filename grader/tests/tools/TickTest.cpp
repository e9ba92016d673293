// The script tick beside a build folder, with a package manager, a ninja and a ticker that only
// pretend.
#include <grader/tests/support/RunCommand.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace ticker {
namespace {

namespace fs = std::filesystem;

class Tick : public testing::Test {
protected:
    void SetUp() override {
        fs::copy(fs::path{TICKER_SOURCE_DIR} / "tick", at("tick"));
        folder_.write("build/release/build.ninja", "");
        folder_.write("build/release/CMakeCache.txt", "TICKER_BUILD_BENCHMARKS:BOOL=ON\n");
        program("build/release/bin/ticker", "echo \"ran $*\"");
        program("bin/dpkg-query", "shift 2; for name; do echo \"ii  $name\"; done");
        setDryRun("ninja: no work to do.");
    }

    void program(const std::string& name, const std::string& text) const {
        fs::permissions(folder_.write(name, "#!/bin/sh\n" + text + "\n"), fs::perms::owner_all);
    }
    void setDryRun(const std::string& lastLine) const {
        program("bin/ninja", "echo \"$*\" >> '" + at("calls").string() +
                                 "'; case \"$*\" in *' -n '*) echo '" + lastLine + "';; esac");
    }
    // As on a machine of people: CI's configures with other options.
    [[nodiscard]] tests::CommandResult run(const std::string& words) const {
        return tests::runCommand("env -u CI PATH='" + at("bin").string() + "':\"$PATH\" '" +
                                 at("tick").string() + "' " + words);
    }
    [[nodiscard]] std::string calls() const {
        return tests::runCommand("cat '" + at("calls").string() + "'").output;
    }
    [[nodiscard]] fs::path at(const std::string& name) const { return folder_.path() / name; }

    tests::TemporaryFolder folder_;
};

TEST_F(Tick, IsQuietWhereNothingIsToBeBuilt) {
    const tests::CommandResult ran = run("compare a.png b.png");
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.output, "ran compare a.png b.png\n");
    EXPECT_NE(calls().find("build.ninja\n"), std::string::npos)
        << "new files are looked for: " << calls();
}

TEST_F(Tick, SaysThatItBuildsAndBuildsWhereSomethingIs) {
    setDryRun("[12/12] Linking CXX executable bin/ticker");
    const tests::CommandResult ran = run("compare a.png b.png");
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.output,
              "tick: building what has changed or is missing\nran compare a.png b.png\n");
    EXPECT_TRUE(calls().ends_with("release product\n")) << calls();
}

TEST_F(Tick, BuildsThoughItCannotTellWhatIsToBeDone) {
    setDryRun("ninja: error: unknown target 'product'");
    EXPECT_NE(run("doctor").output.find("building"), std::string::npos);
    EXPECT_TRUE(calls().ends_with("release product\n")) << calls();
}

TEST_F(Tick, GuardRefusesWhatItDoesNotKnowBeforeItInstallsAnything) {
    program("bin/dpkg-query", "true");
    program("bin/apt-get", "echo apt-get >> '" + at("calls").string() + "'");
    for (const char* words : {"guard", "guard fomrat", "guard all format", "guard load 1 2 3"}) {
        const tests::CommandResult ran = run(words);
        EXPECT_EQ(ran.status, 2) << words;
        EXPECT_EQ(ran.output.find("tick: " + std::string{words}), 0U) << ran.output;
    }
    EXPECT_EQ(calls().find("apt-get"), std::string::npos) << calls();
}

TEST_F(Tick, GuardLoadTakesTheNumbersOfSubmissionsAndKills) {
    program("tools/guards/load", "echo \"load: $*\"");
    EXPECT_EQ(run("guard load 200 5").output, "load: 200 5\n");
}

TEST_F(Tick, InstallsNothingWhereAPackageIsOnHold) {
    program("bin/dpkg-query", "shift 2; for name; do echo \"hi  $name\"; done");
    program("bin/apt-get", "echo apt-get >> '" + at("calls").string() + "'");
    const tests::CommandResult ran = run("compare a.png b.png");
    EXPECT_EQ(ran.output, "ran compare a.png b.png\n");
    EXPECT_EQ(calls().find("apt-get"), std::string::npos) << calls();
}

// Which mistakes the public tests notice is asked of the tests, which a first build leaves out.
TEST_F(Tick, CoverageBuildsTheTests) {
    program("build/release/bin/ticker-lab", "echo \"ran $*\"");
    program("bin/cmake", "echo \"cmake $*\" >> '" + at("calls").string() + "'");
    EXPECT_EQ(run("coverage --write a.md").status, 0);
    EXPECT_NE(calls().find("cmake --preset release -DTICKER_BUILD_TESTS=ON"), std::string::npos)
        << calls();
}

TEST_F(Tick, BenchRefusesWhatItDoesNotKnow) {
    for (const char* words :
         {"bench --json", "bench orcale", "bench --json a b", "bench --jsn a"}) {
        const tests::CommandResult ran = run(words);
        EXPECT_EQ(ran.status, 2) << words;
        EXPECT_EQ(ran.output.find("tick: " + std::string{words} + ": expected "), 0U) << ran.output;
    }
}

}  // namespace
}  // namespace ticker
