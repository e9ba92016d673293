// A run over a class under faults of the machine, other programs and odd class folders.
#include <grader/tests/support/TemporaryFolder.h>

#include "RunTicker.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/mount.h>
#include <unistd.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

class UnderFault : public testing::Test {
protected:
    UnderFault() {
        fs::create_directory(at("class"));
        fs::copy(sample("notAwarded/template-untouched"), at("class/ann"));
    }

    Ran run(const std::string& arguments) {
        return runTicker(arguments, (folder_.path() / "errors").string());
    }
    Ran grade(const std::string& more = {}) {
        return run("grade '" + at("class").string() + "' -o '" + out().string() + "' --seed 7 " +
                   more);
    }

    [[nodiscard]] static fs::path sample(const std::string& name) {
        return fs::path{TICKER_SOURCE_DIR} / "grader/corpus/samples" / name;
    }
    [[nodiscard]] fs::path at(const std::string& path) const { return folder_.path() / path; }
    [[nodiscard]] fs::path out() const { return at("out"); }

    tests::TemporaryFolder folder_;
};

TEST_F(UnderFault, TellsOfFoldersOfTheClassThatAreSkipped) {
    fs::create_directory(at("class/.eve"));
    fs::create_directory(at("class/cyd"));
    const Ran ran = grade();
    EXPECT_EQ(ran.status, 0) << ran.errors;
    EXPECT_NE(
        ran.errors.find("ticker: skipped: .eve (its name begins with a dot), cyd (is empty)\n"),
        std::string::npos)
        << ran.errors;
}

TEST_F(UnderFault, MakesOutForItsOwnerAlone) {
    ASSERT_EQ(grade().status, 0);
    EXPECT_EQ(fs::status(out()).permissions(), fs::perms::owner_all);
}

TEST_F(UnderFault, LeavesTheRightsOfAnOutThatIsThere) {
    fs::create_directory(out());
    fs::permissions(out(), fs::perms{0750});
    ASSERT_EQ(grade().status, 0);
    EXPECT_EQ(fs::status(out()).permissions(), fs::perms{0750});
}

TEST_F(UnderFault, NeverReplacesAHandInThatCannotBeKept) {
    ASSERT_EQ(grade().status, 0);
    const auto bytesOf = [&](const std::string& name) {
        std::ifstream file{out() / "ann" / name, std::ios::binary};
        return std::string{std::istreambuf_iterator<char>{file}, {}};
    };
    const std::string result = bytesOf("result.json");
    const std::string code = bytesOf("code/BumpySphere.cpp");
    std::ofstream{out() / "ann/earlier"} << "no folder";
    std::ofstream{at("class/ann/BumpySphere.cpp"), std::ios::app} << "// later\n";
    const Ran ran = grade();
    EXPECT_EQ(ran.status, 2);
    EXPECT_NE(ran.errors.find("the earlier hand-in cannot be moved"), std::string::npos)
        << ran.errors;
    EXPECT_TRUE(bytesOf("result.json") == result);
    EXPECT_TRUE(bytesOf("code/BumpySphere.cpp") == code);
}

TEST_F(UnderFault, EveryVerbSaysWhatToDoAboutABrokenStore) {
    ASSERT_EQ(grade().status, 0);
    std::ofstream{out() / "results.sqlite"} << std::string(5000, 'x');
    const std::string quoted = "'" + out().string() + "'";
    for (const std::string& words :
         {"report " + quoted, "session " + quoted, "collect " + quoted}) {
        const Ran ran = run(words);
        EXPECT_EQ(ran.status, 2) << words;
        EXPECT_NE(ran.errors.find("ticker collect OUT"), std::string::npos) << ran.errors;
    }
    fs::remove(out() / "results.sqlite");
    EXPECT_EQ(run("collect " + quoted).status, 0) << "the advice works";
    EXPECT_EQ(run("report " + quoted).status, 0);
}

TEST_F(UnderFault, SessionRefusesAStoreWithoutResultsAsReportDoes) {
    ASSERT_EQ(grade().status, 0);
    const std::string quoted = "'" + out().string() + "'";
    for (const char* suffix : {"", "-wal", "-shm"})
        fs::remove(out() / (std::string{"results.sqlite"} + suffix));
    static_cast<void>(std::ofstream{out() / "results.sqlite"});
    const Ran report = run("report " + quoted);
    const Ran session = run("session " + quoted);
    EXPECT_EQ(session.status, 2);
    EXPECT_EQ(session.errors, report.errors);
    EXPECT_NE(session.errors.find("its results.sqlite is empty, but 1 lie"), std::string::npos)
        << session.errors;
}

/// A small disk for temporary files; only root can create one.
class FullDisk : public UnderFault, public testing::WithParamInterface<const char*> {
protected:
    void SetUp() override {
        fs::permissions(folder_.path(), fs::perms{0711});  // jobs have a user of their own
        fs::create_directory(at("small"));
        const std::string size = std::string{"mode=1777,size="} + GetParam();
        if (mount("none", at("small").c_str(), "tmpfs", 0, size.c_str()) != 0)
            GTEST_SKIP() << "no disk of its own to be had here";
        setenv("TMPDIR", at("small").c_str(), 1);
        if (run("doctor").output.find("sandbox B") == std::string::npos)
            GTEST_SKIP() << "no level B here";
    }
    void TearDown() override {
        unsetenv("TMPDIR");
        umount2(at("small").c_str(), MNT_DETACH);
    }
};

TEST_P(FullDisk, IsNeverTheStudentsFault) {
    fs::copy(sample("awarded/reference-bump"), at("class/bob"));
    fs::copy(sample("awarded/reference-distributed"), at("class/cyd"));
    const Ran ran = grade("--sandbox B --jobs 2");
    ASSERT_EQ(ran.status, 3) << ran.output << ran.errors;
    for (const char* name : {"bob", "cyd"}) {
        std::ifstream file{out() / name / "result.json"};
        const nlohmann::json result = nlohmann::json::parse(file);
        EXPECT_EQ(result.at("verdict"), "notGraded") << name;
        EXPECT_NE(result.at("tasks").dump().find("MB free"), std::string::npos) << name;
    }
}

TEST_P(FullDisk, IsNamedByDoctorWithWhatToDo) {
    const Ran ran = run("doctor");
    EXPECT_NE(ran.output.find("temporary files in " + at("small").string() +
                              "; 1.1 GB are enough: free some, or set TMPDIR"),
              std::string::npos)
        << ran.output;
}

TEST_P(FullDisk, LeavesAnEarlierResultOfTheSameFilesAsItIs) {
    fs::copy(sample("notAwarded/does-not-compile"), at("class/bob"));
    unsetenv("TMPDIR");
    ASSERT_EQ(grade().status, 0);
    setenv("TMPDIR", at("small").c_str(), 1);
    const Ran ran = grade("--sandbox B --regrade all");
    EXPECT_EQ(ran.status, 3) << ran.output << ran.errors;
    EXPECT_NE(ran.output.find("[the earlier result stays]"), std::string::npos) << ran.output;
    EXPECT_NE(ran.errors.find("1 submission could not be graded anew (bob), and the earlier result "
                              "of the same files stays. Why: "),
              std::string::npos)
        << ran.errors;
    std::ifstream file{out() / "bob/result.json"};
    EXPECT_EQ(nlohmann::json::parse(file).at("verdict"), "notAwarded");
    EXPECT_FALSE(fs::exists(out() / "bob/earlier"));
    unsetenv("TMPDIR");
    EXPECT_NE(grade("--resume").output.find("bob"), std::string::npos);
    EXPECT_FALSE(fs::exists(out() / "bob/earlier"));
}

INSTANTIATE_TEST_SUITE_P(Sizes, FullDisk, testing::Values("3m", "5m", "20m"),
                         [](const auto& size) { return std::string{size.param}; });

}  // namespace
}  // namespace ticker::cli
