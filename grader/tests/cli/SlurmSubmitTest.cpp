// The script that submits a class to a cluster, with a stand-in for sbatch; tests/cluster has a
// real one.
#include <grader/tests/support/Files.h>
#include <grader/tests/support/RunCommand.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

class SlurmSubmit : public testing::Test {
protected:
    void SetUp() override {
        folder_.write("bin/sbatch", "#!/bin/sh\necho \"$@\"\n");
        fs::permissions(at("bin/sbatch"), fs::perms::owner_all);
        fs::create_directory(at("class"));
    }
    [[nodiscard]] fs::path at(const std::string& name) const { return folder_.path() / name; }
    /// Calls a copy of the script, beside which no ticker is.
    [[nodiscard]] tests::CommandResult submit(const std::string& settings) const {
        return tests::runCommand(
            "cd '" + folder_.path().string() +
            "' && umask 022 && cp " TICKER_SOURCE_DIR
            "/grader/integrations/slurm/submit bin/ && PATH=\"$PWD/bin:$PATH\" " +
            settings + " bin/submit class out 3");
    }

    tests::TemporaryFolder folder_;
};

constexpr auto kOthers = fs::perms::group_all | fs::perms::others_all;

TEST_F(SlurmSubmit, MakesAnOutThatOnlyItsOwnerCanRead) {
    const tests::CommandResult ran = submit("TICKER=/bin/true");
    ASSERT_EQ(ran.status, 0) << ran.output;
    EXPECT_NE(ran.output.find("--array=1-3"), std::string::npos) << ran.output;
    EXPECT_EQ(fs::status(at("out")).permissions() & kOthers, fs::perms::none);
}

TEST_F(SlurmSubmit, LeavesThePermissionsOfAnOutThatIsThere) {
    fs::create_directory(at("out"));
    fs::permissions(at("out"), fs::perms{0750});
    EXPECT_EQ(submit("TICKER=/bin/true").status, 0);
    EXPECT_EQ(fs::status(at("out")).permissions(), fs::perms{0750});
}

TEST_F(SlurmSubmit, SaysThatTickerIsMissingBeforeItSubmitsAnything) {
    for (const char* settings : {"TICKER=/nowhere/ticker", "TICKER=/bin", "TICKER="}) {
        const tests::CommandResult ran = submit(settings);
        EXPECT_EQ(ran.status, 2) << ran.output;
        EXPECT_TRUE(ran.output.starts_with("submit: ticker is not found")) << ran.output;
    }
    EXPECT_FALSE(fs::exists(at("out")));
}

TEST_F(SlurmSubmit, SaysThatTheClassIsMissingBeforeItSubmitsAnything) {
    fs::remove(at("class"));
    const tests::CommandResult ran = submit("TICKER=/bin/true");
    EXPECT_EQ(ran.status, 2) << ran.output;
    EXPECT_EQ(ran.output, "submit: the class class is not there\n");
    EXPECT_FALSE(fs::exists(at("out")));
}

}  // namespace
}  // namespace ticker::cli
