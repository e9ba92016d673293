#include <grader/tests/support/FitsSchema.h>
#include <grader/tests/support/TemporaryFolder.h>

#include "CleanRoot.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>

namespace ticker {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using tests::CleanRoot;
using tests::RootRun;

const std::string kTicker = TICKER_BINARY_DIR "/bin/ticker";
const std::string kCandidates = TICKER_BINARY_DIR "/bin/ticker-candidates";

fs::path sample(const std::string& name) {
    return fs::path{TICKER_SOURCE_DIR} / "grader/corpus/samples" / name;
}

/// PrairieLearn's package of an exercise, made once for all tests: most of the time is compression.
class PrairieLearnPackage {
public:
    static const PrairieLearnPackage& of(const std::string& exercise) {
        static std::map<std::string, std::unique_ptr<const PrairieLearnPackage>> packages;
        auto& package = packages[exercise];
        if (!package)
            package = std::unique_ptr<const PrairieLearnPackage>{new PrairieLearnPackage{exercise}};
        return *package;
    }
    [[nodiscard]] fs::path zip() const { return folder_.path() / "pl.zip"; }
    [[nodiscard]] const std::string& problem() const { return problem_; }

private:
    explicit PrairieLearnPackage(const std::string& exercise) {
        const RootRun made = tests::runHere(kTicker + " package prairielearn --exercise " +
                                            exercise + " -o " + zip().string());
        if (made.status != 0) problem_ = made.output + made.errors;
    }

    tests::TemporaryFolder folder_;
    std::string problem_;
};

/// An unpacked package for which the platform has built its image; shared by all tests.
class Image {
public:
    static const Image& get() {
        static const Image image;
        return image;
    }
    [[nodiscard]] fs::path at(const std::string& name) const { return folder_.path() / name; }
    [[nodiscard]] const std::string& problem() const { return problem_; }

private:
    Image() {
        const RootRun made = tests::runHere("cd " + folder_.path().string() + " && " + kTicker +
                                            " package gradescope -o gradescope.zip && "
                                            "unzip -q -d source gradescope.zip");
        if (made.status != 0) problem_ = made.errors;
        // There is no network: with all packages present, apt-get must not be called.
        const RootRun setup =
            CleanRoot{}.bind(at("source"), "/autograder/source").run("/autograder/source/setup.sh");
        if (setup.status != 0) problem_ += setup.output + setup.errors;
    }

    tests::TemporaryFolder folder_;
    std::string problem_;
};

class Platforms : public testing::Test {
protected:
    void SetUp() override { ASSERT_EQ(Image::get().problem(), ""); }

    [[nodiscard]] static fs::path image(const std::string& name) { return Image::get().at(name); }
    [[nodiscard]] fs::path at(const std::string& name) const { return folder_.path() / name; }

    tests::TemporaryFolder folder_;
};

class Gradescope : public Platforms {
protected:
    Gradescope() {
        for (const char* folder : {"results", "submission"}) {
            fs::create_directory(at(folder));
            root_.bind(at(folder), std::string{"/autograder/"} + folder);
        }
        root_.bindReadOnly(image("source"), "/autograder/source");
    }

    void submit(const std::string& name) const {
        fs::copy(sample(name), at("submission"), fs::copy_options::recursive);
    }
    [[nodiscard]] RootRun grade() const {
        return root_.runInContainer("cd /autograder && source/run_autograder");
    }
    [[nodiscard]] std::string results() const { return tests::textOf(at("results/results.json")); }

    CleanRoot root_;
};

TEST_F(Gradescope, AwardsARightSubmissionInASandboxOfLevelB) {
    submit("awarded/reference-bump");
    const RootRun ran = grade();
    ASSERT_EQ(ran.status, 0) << ran.output << ran.errors;
    EXPECT_TRUE(tests::fitsSchema(results(), "gradescope")) << results();
    EXPECT_EQ(json::parse(results()).at("score"), 1.0) << results();
    // Staff see more than students.
    EXPECT_NE(ran.output.find("\"seed\""), std::string::npos) << ran.output;
    EXPECT_EQ(results().find("seed"), std::string::npos);
    if (geteuid() == 0) {
        EXPECT_NE(ran.output.find("\"sandboxLevel\": \"B\""), std::string::npos) << ran.output;
    }
}

TEST_F(Gradescope, TellsAStudentWhatTheCompilerSaid) {
    submit("notAwarded/does-not-compile");
    ASSERT_EQ(grade().status, 0);
    EXPECT_TRUE(tests::fitsSchema(results(), "gradescope"));
    EXPECT_EQ(json::parse(results()).at("score"), 0.0);
    EXPECT_NE(results().find("error:"), std::string::npos) << results();
}

TEST_F(Gradescope, LeavesNoScoreWhereWeFailed) {
    submit("awarded/reference-bump");
    root_.bindReadOnly("/dev/null", "/autograder/source/ticker/lib/ticker/kit/tick1star/kit.json");
    EXPECT_NE(grade().status, 0);
    EXPECT_EQ(results(), "");
}

TEST_F(Platforms, PrairieLearnGetsAResultOrIsToldThatThereIsNone) {
    // The parts that differ; the others are in the other package, already prepared.
    const PrairieLearnPackage& package = PrairieLearnPackage::of("tick1star");
    ASSERT_EQ(package.problem(), "");
    const std::string zip = package.zip().string();
    const RootRun made = tests::runHere(
        "mkdir -p " + at("image/ticker").string() + " && cd " + at("image").string() +
        " && unzip -q " + zip + " entrypoint.sh Dockerfile 'question/*' && unzip -Z1 " + zip +
        " 'ticker/*' | sort >pl.txt && unzip -Z1 " + image("gradescope.zip").string() +
        " 'ticker/*' | sort | cmp - pl.txt");
    ASSERT_EQ(made.status, 0) << made.output << made.errors;
    const json info = json::parse(tests::textOf(at("image/question/info.json")));
    EXPECT_EQ(info.at("gradingMethod"), "External");
    EXPECT_LE(info.at("externalGradingOptions").at("timeout"), 600) << "PrairieLearn's most";

    fs::create_directories(at("grade/student"));
    fs::copy(sample("awarded/reference-bump"), at("grade/student"), fs::copy_options::recursive);
    CleanRoot root;
    root.bind(at("grade"), "/grade")
        .bindReadOnly(at("image"), "/opt/ticker")
        .bindReadOnly(image("source/ticker"), "/opt/ticker/ticker");
    const auto results = [&] { return tests::textOf(at("grade/results/results.json")); };
    RootRun ran = root.runInContainer("/opt/ticker/entrypoint.sh");
    ASSERT_EQ(ran.status, 0) << ran.output << ran.errors;
    EXPECT_TRUE(tests::fitsSchema(results(), "prairielearn")) << results();
    EXPECT_EQ(json::parse(results()).at("score"), 1.0);

    root.bindReadOnly("/dev/null", "/opt/ticker/ticker/lib/ticker/kit/tick1star/kit.json");
    ran = root.runInContainer("/opt/ticker/entrypoint.sh");
    EXPECT_EQ(ran.status, 0) << "anything else throws the results away";
    EXPECT_TRUE(tests::fitsSchema(results(), "prairielearn")) << results();
    EXPECT_EQ(json::parse(results()).at("gradable"), false);
}

TEST(PrairieLearn, AsksForTheFilesOfEachExercise) {
    tests::TemporaryFolder folder;
    std::set<std::string> ids;
    for (const std::string exercise : {"tick1star", "tick1"}) {
        const PrairieLearnPackage& package = PrairieLearnPackage::of(exercise);
        ASSERT_EQ(package.problem(), "");
        const RootRun made = tests::runHere("unzip -q -d " + (folder.path() / exercise).string() +
                                            " " + package.zip().string() + " 'question/*'");
        ASSERT_EQ(made.status, 0) << made.output << made.errors;
        const fs::path question = folder.path() / exercise / "question";
        const json info = json::parse(tests::textOf(question / "info.json"));
        EXPECT_TRUE(ids.insert(info.at("uuid")).second) << info;
        EXPECT_EQ(info.at("externalGradingOptions").at("image"), "course/" + exercise);
        const std::string page = tests::textOf(question / "question.html");
        EXPECT_EQ(page.find('@'), std::string::npos) << page;
        EXPECT_EQ(page.find("screenshot.png") != std::string::npos, exercise == "tick1star")
            << page;
    }
}

TEST_F(Platforms, ClassroomsStepHandsTheResultOverAndPrintsNothing) {
    const fs::path box = at("repository");
    fs::create_directories(box / "exercise");
    fs::create_directories(box / "framework/src/geometry");
    fs::copy(sample("awarded/reference-bump/BumpySphere.cpp"), box / "exercise");
    fs::copy(sample("awarded/reference-bump/screenshot.png"), box);
    // The skeleton's file of the same name.
    fs::copy(TICKER_SOURCE_DIR "/student_template/framework/src/geometry/BumpySphere.cpp",
             box / "framework/src/geometry");
    CleanRoot root;
    root.bind(box, "/desk")
        .bindReadOnly(image("source/ticker"), "/opt/ticker")
        .bindReadOnly(TICKER_SOURCE_DIR "/grader/integrations/classroom", "/classroom")
        .set("TICKER", "/opt/ticker/bin/ticker")
        .set("GITHUB_OUTPUT", "/desk/output")
        .set("GITHUB_STEP_SUMMARY", "/desk/summary");
    const RootRun ran = root.run("cd /desk && /classroom/grade");
    ASSERT_EQ(ran.status, 0) << ran.errors;
    EXPECT_EQ(ran.output, "") << "GitHub takes lines for commands";
    const RootRun decoded =
        tests::runHere("sed -n 's/^result=//p' " + (box / "output").string() + " | base64 -d");
    EXPECT_TRUE(tests::fitsSchema(decoded.output, "classroom")) << decoded.output;
    EXPECT_EQ(json::parse(decoded.output).at("status"), "pass");
    const std::string summary = tests::textOf(box / "summary");
    EXPECT_TRUE(summary.starts_with("<pre>\nTick awarded.\n")) << summary;
}

/// What the packages of the image's Dockerfile hold, as far as they are installed here.
std::string filesOfTheImagesPackages() {
    return tests::runHere("sed -n '/apt-get install/,/rm -rf/p' " TICKER_SOURCE_DIR
                          "/grader/integrations/docker/Dockerfile | grep -o "
                          "'[a-z][a-z0-9.+-]*[a-z0-9]' | xargs dpkg-query -L 2>/dev/null")
        .output;
}

TEST(Docker, TheImageInstallsEveryPackageWhoseLibrariesTickerNeeds) {
    const std::string carried = filesOfTheImagesPackages();
    for (const std::string& program : {kTicker, kCandidates}) {
        if (program == kCandidates && !fs::exists(program)) continue;  // made where libclang is
        const RootRun needed =
            tests::runHere("objdump -p " + program + " | awk '/NEEDED/ {print $2}'");
        ASSERT_NE(needed.output, "") << needed.errors;
        std::istringstream libraries{needed.output};
        for (std::string library; libraries >> library;)
            // Every g++ installs these.
            if (!library.starts_with("libc.") && !library.starts_with("libm.") &&
                !library.starts_with("libstdc++") && !library.starts_with("libgcc_s")) {
                EXPECT_NE(carried.find("/" + library), std::string::npos) << library;
            }
    }
}

TEST(Docker, TheImageInstallsTheHeadersThatClangsParserBrings) {
    if (!fs::exists(kCandidates)) GTEST_SKIP() << "needs libclang";
    EXPECT_NE(filesOfTheImagesPackages().find("/include/stddef.h\n"), std::string::npos);
}

TEST(Docker, TheImageInstallsWhatLooksForSharedPassages) {
    if (!fs::exists("/usr/bin/sim_c++")) GTEST_SKIP() << "needs similarity-tester";
    EXPECT_NE(filesOfTheImagesPackages().find("/usr/bin/sim_c++"), std::string::npos);
}

}  // namespace
}  // namespace ticker
