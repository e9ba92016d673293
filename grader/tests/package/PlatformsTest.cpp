#include <grader/tests/report/FitsSchema.h>
#include <grader/tests/support/TemporaryFolder.h>

#include "CleanRoot.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <filesystem>
#include <sstream>
#include <string>

namespace ticker {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using tests::CleanRoot;
using tests::RootRun;

const std::string kTicker = TICKER_BINARY_DIR "/bin/ticker";

fs::path sample(const std::string& name) {
    return fs::path{TICKER_SOURCE_DIR} / "grader/samples" / name;
}

/// Makes a package, unpacks it, and lets the platform build its image: once for all tests.
class Platforms : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder_ = new tests::TemporaryFolder;
        const RootRun made = tests::runHere("cd " + at("").string() + " && " + kTicker +
                                            " package gradescope -o gradescope.zip && "
                                            "unzip -q -d source gradescope.zip");
        ASSERT_EQ(made.status, 0) << made.errors;
        // There is no network: apt-get must not be needed where all is there.
        const RootRun setup =
            CleanRoot{}.bind(at("source"), "/autograder/source").run("/autograder/source/setup.sh");
        ASSERT_EQ(setup.status, 0) << setup.output << setup.errors;
    }
    static void TearDownTestSuite() {
        delete folder_;
        folder_ = nullptr;
    }

    [[nodiscard]] static fs::path at(const std::string& name) { return folder_->path() / name; }

    /// A fresh folder of this name with folders in it.
    static fs::path fresh(const std::string& name, std::initializer_list<const char*> folders) {
        fs::remove_all(at(name));
        for (const char* folder : folders)
            fs::create_directories(at(name) / folder);
        return at(name);
    }

    static tests::TemporaryFolder* folder_;
};

tests::TemporaryFolder* Platforms::folder_ = nullptr;

class Gradescope : public Platforms {
protected:
    Gradescope() : box_(fresh("autograder", {"results", "submission"})) {
        root_.bind(box_ / "results", "/autograder/results")
            .bind(box_ / "submission", "/autograder/submission")
            .bindReadOnly(at("source"), "/autograder/source");
    }

    void submit(const std::string& name) const {
        fs::copy(sample(name), box_ / "submission", fs::copy_options::recursive);
    }
    [[nodiscard]] RootRun grade() const {
        return root_.runInContainer("cd /autograder && source/run_autograder");
    }
    [[nodiscard]] std::string results() const {
        return tests::textOf(box_ / "results" / "results.json");
    }

    fs::path box_;
    CleanRoot root_;
};

TEST_F(Gradescope, AwardsARightSubmissionInASandboxOfLevelB) {
    submit("awarded/reference-bump");
    const RootRun ran = grade();
    ASSERT_EQ(ran.status, 0) << ran.output << ran.errors;
    EXPECT_TRUE(report::fitsSchema(results(), "gradescope")) << results();
    EXPECT_EQ(json::parse(results()).at("score"), 1.0) << results();
    // Staff see what students do not.
    EXPECT_NE(ran.output.find("\"seed\""), std::string::npos) << ran.output;
    EXPECT_EQ(results().find("seed"), std::string::npos);
    if (geteuid() == 0) {
        EXPECT_NE(ran.output.find("\"sandboxLevel\": \"B\""), std::string::npos) << ran.output;
    }
}

TEST_F(Gradescope, TellsAStudentWhatTheCompilerSaid) {
    submit("notAwarded/does-not-compile");
    ASSERT_EQ(grade().status, 0);
    EXPECT_TRUE(report::fitsSchema(results(), "gradescope"));
    EXPECT_EQ(json::parse(results()).at("score"), 0.0);
    EXPECT_NE(results().find("error:"), std::string::npos) << results();
}

TEST_F(Gradescope, LeavesNoScoreWhereWeFailed) {
    submit("awarded/reference-bump");
    root_.bindReadOnly("/dev/null", "/autograder/source/ticker/lib/ticker/kit/kit.json");
    EXPECT_NE(grade().status, 0);
    EXPECT_EQ(results(), "");
}

class PrairieLearn : public Platforms {
protected:
    PrairieLearn() : box_(fresh("pl", {"grade/student", "image"})) {
        // The parts that differ; the rest is what the other package carries, prepared already.
        const RootRun made = tests::runHere(
            "cd " + (box_ / "image").string() + " && " + kTicker +
            " package prairielearn -o pl.zip && unzip -q pl.zip entrypoint.sh Dockerfile "
            "'question/*' && unzip -Z1 pl.zip 'ticker/*' | sort >pl.txt && "
            "unzip -Z1 " +
            at("gradescope.zip").string() + " 'ticker/*' | sort | cmp - pl.txt");
        EXPECT_EQ(made.status, 0) << made.output << made.errors;
        root_.bind(box_ / "grade", "/grade")
            .bindReadOnly(box_ / "image", "/opt/ticker")
            .bindReadOnly(at("source") / "ticker", "/opt/ticker/ticker");
        fs::create_directory(box_ / "image" / "ticker");
    }

    [[nodiscard]] std::string results() const {
        return tests::textOf(box_ / "grade/results/results.json");
    }

    fs::path box_;
    CleanRoot root_;
};

TEST_F(PrairieLearn, GradesWhatIsInItsFolderOrSaysThatItIsNotGradable) {
    fs::copy(sample("awarded/reference-bump"), box_ / "grade/student", fs::copy_options::recursive);
    RootRun ran = root_.runInContainer("/opt/ticker/entrypoint.sh");
    ASSERT_EQ(ran.status, 0) << ran.output << ran.errors;
    EXPECT_TRUE(report::fitsSchema(results(), "prairielearn")) << results();
    EXPECT_EQ(json::parse(results()).at("score"), 1.0);

    root_.bindReadOnly("/dev/null", "/opt/ticker/ticker/lib/ticker/kit/kit.json");
    ran = root_.runInContainer("/opt/ticker/entrypoint.sh");
    EXPECT_EQ(ran.status, 0) << "anything else throws the results away";
    EXPECT_TRUE(report::fitsSchema(results(), "prairielearn")) << results();
    EXPECT_EQ(json::parse(results()).at("gradable"), false);
}

TEST_F(PrairieLearn, TheQuestionsFilesAreWellFormed) {
    const json info = json::parse(tests::textOf(box_ / "image/question/info.json"));
    EXPECT_EQ(info.at("gradingMethod"), "External");
    EXPECT_LE(info.at("externalGradingOptions").at("timeout"), 600) << "PrairieLearn's most";
}

TEST_F(Platforms, ClassroomsStepHandsTheResultOverAndPrintsNothing) {
    const fs::path box = fresh("repository", {"exercise", "framework/src/geometry"});
    fs::copy(sample("awarded/reference-bump/BumpySphere.cpp"), box / "exercise");
    fs::copy(sample("awarded/reference-bump/screenshot.png"), box);
    // The skeleton's own file of the same name.
    fs::copy(TICKER_SOURCE_DIR "/student_template/framework/src/geometry/BumpySphere.cpp",
             box / "framework/src/geometry");
    CleanRoot root;
    root.bind(box, "/work")
        .bindReadOnly(at("source") / "ticker", "/opt/ticker")
        .bindReadOnly(TICKER_SOURCE_DIR "/grader/integrations/classroom", "/classroom")
        .set("TICKER", "/opt/ticker/bin/ticker")
        .set("GITHUB_OUTPUT", "/work/output");
    const RootRun ran = root.run("cd /work && /classroom/grade");
    ASSERT_EQ(ran.status, 0) << ran.errors;
    EXPECT_EQ(ran.output, "") << "GitHub takes lines for commands";
    const RootRun decoded =
        tests::runHere("sed -n 's/^result=//p' " + (box / "output").string() + " | base64 -d");
    EXPECT_TRUE(report::fitsSchema(decoded.output, "classroom")) << decoded.output;
    EXPECT_EQ(json::parse(decoded.output).at("status"), "pass");
}

TEST(Docker, TheImageInstallsEveryPackageWhoseLibrariesTickerNeeds) {
    const std::string dockerfile =
        tests::textOf(TICKER_SOURCE_DIR "/grader/integrations/docker/Dockerfile");
    const RootRun needed = tests::runHere(
        "objdump -p " + kTicker +
        " | awk '/NEEDED/ {print \"*/\" $2}' | xargs dpkg-query -S | sed 's/:.*//' | sort -u");
    ASSERT_NE(needed.output.find("libopencv"), std::string::npos) << needed.errors;
    std::istringstream packages{needed.output};
    for (std::string package; packages >> package;)
        // Every g++ brings these.
        if (package != "libc6" && package != "libstdc++6" && package != "libgcc-s1") {
            EXPECT_NE(dockerfile.find(" " + package), std::string::npos) << package;
        }
}

}  // namespace
}  // namespace ticker
