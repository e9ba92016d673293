// Results that lie in a class are not graded as students.
#include <grader/intake/Intake.h>
#include <grader/intake/Skipped.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::intake {
namespace {

namespace fs = std::filesystem;

using ClassNames = std::vector<std::string>;

ClassNames classIn(const fs::path& path, const fs::path& out = {}) {
    ClassNames names;
    for (const Located& located : findSubmissions(path, defaultExercise(), out))
        names.push_back(located.name);
    return names;
}

void writeResults(const tests::TemporaryFolder& folder, const std::string& out) {
    folder.write(out + "/ann/code/Renderer.cpp", "x");
    folder.write(out + "/ann/images/screenshot.png", "p");
    folder.write(out + "/ann/result.json", "{}");
    folder.write(out + "/index.html", "page");
}

TEST(OutFolder, OfAnEarlierRunIsNoStudentOfItsClass) {
    for (const char* mark : {"results.sqlite", ".ticker-lock"}) {
        const tests::TemporaryFolder folder;
        folder.write("ann/Renderer.cpp", "x");
        writeResults(folder, "out");
        folder.write(std::string{"out/"} + mark, "");
        EXPECT_EQ(classIn(folder.path()), ClassNames{"ann"}) << mark;
        const auto skipped = findSkipped(folder.path(), findSubmissions(folder.path()));
        ASSERT_EQ(skipped.size(), 1U);
        EXPECT_EQ(skipped[0].why, "holds results of ticker");
    }
}

TEST(OutFolder, OfThisRunNeedsNoMarkAndIsNotSpokenOf) {
    const tests::TemporaryFolder folder;
    folder.write("ann/Renderer.cpp", "x");
    writeResults(folder, "out");
    const fs::path out = folder.path() / "out";
    EXPECT_EQ(classIn(folder.path(), out), ClassNames{"ann"});
    const auto found = findSubmissions(folder.path(), defaultExercise(), out);
    EXPECT_TRUE(findSkipped(folder.path(), found, out).empty());
}

TEST(OutFolder, InAnUnpackedExportIsNobodysWork) {
    const tests::TemporaryFolder folder;
    folder.write("Ann_1_assignsubmission_file/Renderer.cpp", "x");
    folder.write("Bob_2_assignsubmission_file/Renderer.cpp", "x");
    writeResults(folder, "out");
    folder.write("out/results.sqlite", "");
    EXPECT_EQ(classIn(folder.path()), (ClassNames{"Ann_1", "Bob_2"}));
}

TEST(OutFolder, InASubmissionIsNoPartOfIt) {
    const tests::TemporaryFolder folder;
    folder.write("Renderer.cpp", "mine");
    folder.write("screenshot.png", "mine");
    writeResults(folder, "out");
    const Located ann{"ann", folder.path(), "", folder.path() / "out"};
    EXPECT_TRUE(readSubmission(ann).findings.empty());
    EXPECT_EQ(readSubmission({"ann", folder.path()}).findings.size(), 2U) << "two of each name";
    folder.write("out/results.sqlite", "");
    const Submission read = readSubmission({"ann", folder.path()});
    EXPECT_TRUE(read.findings.empty());
    EXPECT_EQ(read.part("Renderer.cpp"), "mine");
}

TEST(OutFolder, IsNotMadeOfAStudentsFolderByAFileOfThatName) {
    const tests::TemporaryFolder folder;
    folder.write("ann/Renderer.cpp", "x");
    folder.write("ann/results.sqlite", "x");
    folder.write("bob/Renderer.cpp", "x");
    EXPECT_EQ(classIn(folder.path()), (ClassNames{"ann", "bob"}));
    EXPECT_EQ(classIn(folder.path(), folder.path() / "bob"), (ClassNames{"ann", "bob"}));
}

TEST(OutFolder, GivenAsTheInputIsReadAsAClass) {
    const tests::TemporaryFolder folder;
    writeResults(folder, "out");
    folder.write("out/results.sqlite", "");
    folder.write("out/bob/code/Renderer.cpp", "x");
    EXPECT_EQ(classIn(folder.path() / "out"), (ClassNames{"ann", "bob"}));
}

}  // namespace
}  // namespace ticker::intake
