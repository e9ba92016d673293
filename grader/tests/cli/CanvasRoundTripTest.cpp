#include <grader/tests/support/Files.h>
#include <grader/tests/support/MoodleExport.h>
#include <grader/tests/support/RunCommand.h>
#include <grader/tests/support/TemporaryFolder.h>

#include "RunTicker.h"

#include <gtest/gtest.h>

#include <string>

namespace ticker::cli {
namespace {

// The samples hand in a stub, so that nothing has to be compiled.
TEST(CanvasRoundTrip, GradesGoIntoTheGradebookAndCommentsUnderCanvassNames) {
    const tests::TemporaryFolder folder;
    const auto at = [&](const std::string& name) { return (folder.path() / name).string(); };
    const std::string stub =
        tests::readFile("grader/corpus/samples/notAwarded/template-untouched/BumpySphere.cpp");
    tests::writeZip(at("submissions.zip"), {{"leeann_4711_90210_BumpySphere-1.cpp", stub},
                                            {"kimbo_late_99_90305_BumpySphere.cpp", stub}});
    folder.write("gradebook.csv",
                 "Student,ID,SIS User ID,SIS Login ID,Section,Tick 1* (815)\n"
                 "    Points Possible,,,,,10\n"
                 "\"Lee, Ann\",4711,,al1,CS,\n\"Kim, Bo\",99,,bk1,CS,\n\"May, Cy\",100,,cm1,CS,\n");

    const Ran ran = runTicker("grade '" + at("submissions.zip") + "' -o '" + at("out") +
                                  "' --seed 7 --format canvas --worksheet '" + at("gradebook.csv") +
                                  "' --download '" + at("submissions.zip") + "'",
                              at("errors"));
    ASSERT_EQ(ran.status, 0) << ran.errors;
    EXPECT_NE(ran.errors.find("2 graded. Import the gradebook"), std::string::npos) << ran.errors;
    const tests::CommandResult rows =
        tests::runCommand("tail -n 3 '" + at("out/canvas-gradebook.csv") + "'");
    EXPECT_EQ(rows.output,
              "\"Lee, Ann\",4711,,al1,CS,\"0.00\"\n\"Kim, Bo\",99,,bk1,CS,\"0.00\"\n"
              "\"May, Cy\",100,,cm1,CS,\n");
    const tests::CommandResult files =
        tests::runCommand("unzip -Z1 '" + at("out/canvas-comments.zip") + "' | sort");
    EXPECT_EQ(files.output,
              "kimbo_late_99_90305_BumpySphere.cpp\nleeann_4711_90210_BumpySphere-1.cpp\n");
    const tests::CommandResult comment = tests::runCommand(
        "unzip -p '" + at("out/canvas-comments.zip") + "' leeann_4711_90210_BumpySphere-1.cpp");
    EXPECT_TRUE(comment.output.starts_with("/*\n")) << comment.output;
    EXPECT_TRUE(comment.output.ends_with("*/\n" + stub)) << comment.output;
}

TEST(CanvasRoundTrip, CommentsAreMadeForTheFilesOfTheResultsExercise) {
    const tests::TemporaryFolder folder;
    const auto at = [&](const std::string& name) { return (folder.path() / name).string(); };
    tests::writeZip(at("submissions.zip"),
                    {{"leeann_4711_90210_Sphere.cpp",
                      tests::readFile("student_template/tick1/exercise/Sphere.cpp")}});
    folder.write("gradebook.csv",
                 "Student,ID,SIS User ID,SIS Login ID,Section,Tick 1 (815)\n"
                 "    Points Possible,,,,,10\n\"Lee, Ann\",4711,,al1,CS,\n");
    const Ran ran =
        runTicker("grade '" + at("submissions.zip") + "' -o '" + at("out") +
                      "' --exercise tick1 --seed 7 --format canvas --worksheet '" +
                      at("gradebook.csv") + "' --download '" + at("submissions.zip") + "'",
                  at("errors"));
    ASSERT_EQ(ran.status, 0) << ran.errors;
    EXPECT_EQ(ran.errors.find("no comment"), std::string::npos) << ran.errors;
    const tests::CommandResult files =
        tests::runCommand("unzip -Z1 '" + at("out/canvas-comments.zip") + "'");
    EXPECT_EQ(files.output, "leeann_4711_90210_Sphere.cpp\n");
}

}  // namespace
}  // namespace ticker::cli
