// Verbs where results, downloads and temporary folders are not what they should be.
#include <grader/tests/support/Files.h>
#include <grader/tests/support/MoodleExport.h>
#include <grader/tests/support/TemporaryFolder.h>

#include "RunTicker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

const std::string kStub = "grader/corpus/samples/notAwarded/template-untouched/BumpySphere.cpp";

class VerbsInOddPlaces : public testing::Test {
protected:
    Ran run(const std::string& arguments) {
        return runTicker(arguments, (folder_.path() / "errors").string());
    }
    Ran grade(const std::string& place, const std::string& more = {}) {
        return run("grade " + at(place) + " -o " + at("out") + " --seed 7 " + more);
    }
    [[nodiscard]] std::string at(const std::string& path) const {
        return "'" + (folder_.path() / path).string() + "'";
    }

    tests::TemporaryFolder folder_;
};

TEST_F(VerbsInOddPlaces, ResultsInsideTheClassAreNotGradedWithIt) {
    for (const char* name : {"class/ann/BumpySphere.cpp", "class/bob/BumpySphere.cpp"})
        folder_.write(name, tests::readFile(kStub));
    const std::string command = "grade " + at("class") + " -o " + at("class/out") + " --seed 7";
    ASSERT_EQ(run(command).status, 0);
    const Ran again = run(command);
    EXPECT_EQ(again.status, 0) << again.errors;
    EXPECT_EQ(std::count(again.output.begin(), again.output.end(), '\n'), 2) << again.output;
    EXPECT_EQ(again.errors.find("skipped"), std::string::npos) << again.errors;
}

TEST_F(VerbsInOddPlaces, ResultsInsideTheOnlySubmissionAreNoPartOfIt) {
    folder_.write("ann/BumpySphere.cpp", tests::readFile(kStub));
    const std::string command = "grade " + at("ann") + " -o " + at("ann/out") + " --results-only";
    ASSERT_EQ(run(command).status, 0);
    folder_.write("ann/BumpySphere.cpp", tests::readFile(kStub) + "// later\n");
    const Ran again = run(command);
    EXPECT_EQ(again.status, 0) << again.errors;
    EXPECT_EQ(again.output.find("intake."), std::string::npos) << again.output;
}

TEST_F(VerbsInOddPlaces, ADownloadThatBrokeOffIsNotGraded) {
    tests::writeZip(folder_.path() / "class.zip",
                    {{"Ann_1_assignsubmission_file/BumpySphere.cpp", tests::readFile(kStub)},
                     {"Bob_2_assignsubmission_file/BumpySphere.cpp", tests::readFile(kStub)}});
    fs::resize_file(folder_.path() / "class.zip", fs::file_size(folder_.path() / "class.zip") / 2);
    const Ran ran = grade("class.zip");
    EXPECT_EQ(ran.status, 2);
    EXPECT_NE(ran.errors.find("class.zip: this class download is not whole"), std::string::npos)
        << ran.errors;
    EXPECT_NE(ran.errors.find("download it again"), std::string::npos) << ran.errors;
    EXPECT_EQ(ran.output, "");
}

TEST_F(VerbsInOddPlaces, ExplainSaysOfAClassThatNoEditsWereLookedFor) {
    fs::copy(fs::path{TICKER_SOURCE_DIR} / "grader/corpus/samples/notAwarded/bump-inverted-u",
             folder_.path() / "ann");
    ASSERT_EQ(grade("ann").status, 0);
    const Ran ran = run("explain " + at("out"));
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.output, "");
    // Between the two the command stands as it was typed.
    EXPECT_TRUE(ran.errors.starts_with("no edits were looked for in 1 of 1 submission; "));
    EXPECT_TRUE(ran.errors.ends_with(" grade with --explain failed --resume looks for them\n"));
}

TEST_F(VerbsInOddPlaces, ExplainSaysOfAClassThatNoEditCouldMendIt) {
    folder_.write("ann/BumpySphere.cpp", tests::readFile(kStub));
    ASSERT_EQ(grade("ann").status, 0);
    const Ran ran = run("explain " + at("out"));
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.output, "No task failed in a way that an edit of its code could mend.\n");
    EXPECT_EQ(ran.errors, "");
}

TEST_F(VerbsInOddPlaces, CoverageIsAVerbOfTheLab) {
    const Ran ran = run("coverage");
    EXPECT_EQ(ran.status, 2);
    EXPECT_NE(ran.errors.find("is in ticker-lab"), std::string::npos) << ran.errors;
}

TEST_F(VerbsInOddPlaces, DoctorSaysThatTmpdirIsWrong) {
    const std::string nowhere = (folder_.path() / "nowhere").string();
    setenv("TMPDIR", nowhere.c_str(), 1);
    const Ran ran = run("doctor");
    unsetenv("TMPDIR");
    EXPECT_EQ(ran.status, 1) << ran.errors;
    EXPECT_NE(ran.output.find(nowhere), std::string::npos) << ran.output;
    EXPECT_NE(ran.output.find("set TMPDIR to a folder"), std::string::npos) << ran.output;
    EXPECT_EQ(ran.errors, "");
}

}  // namespace
}  // namespace ticker::cli
