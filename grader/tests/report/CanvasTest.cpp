#include <grader/report/platforms/CanvasGradebook.h>
#include <grader/report/platforms/CsvFile.h>

#include <raytracer/base/Error.h>

#include "ExampleResults.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ticker::report {
namespace {

// As Canvas exports it: a byte order mark, two rows before the students, Canvas's own columns last.
const std::string kGradebook =
    "\xEF\xBB\xBFStudent,ID,SIS User ID,SIS Login ID,Section,Essay (814),Tick 1 (815),Final Score\n"
    ",,,,,Manual Posting,,\n"
    "    Points Possible,,,,,10,4,(read only)\n"
    "\"Lee, Ann \"\"A\"\"\",4711,s1,al1,CS,7,,70.0\n"
    "\"Kim, Bo\",99,s2,bk1,CS,,3.5,\n"
    "\"May, Cy\",100,s3,cm1,CS,,,\n"
    "\"Ray, Di\",101,s4,dr1,CS,,EX,\n"
    "\"Student, Test\",5,,0123,CS,,,\n";

StudentView canvasView(SubmissionResult result, const std::string& submission) {
    result.submission = submission;
    return {result, {}};
}

std::vector<StudentView> canvasClass() {
    return {canvasView(passedExample(), "leeann_4711"), canvasView(failedBumpExample(), "kimbo_99"),
            canvasView(reviewExample(), "maycy_100"), canvasView(passedExample(), "raydi_101"),
            canvasView(passedExample(), "gonegus_102")};
}

TEST(CanvasGradebook, ChangesTheAssignmentsCellsOfGradedStudentsAndNoOtherByte) {
    const CanvasGrades grades = fillCanvasGradebook(kGradebook, "g.csv", "Tick 1", canvasClass());
    std::string expected = kGradebook;
    const std::string ann = "4711,s1,al1,CS,7,,70.0";
    expected.replace(expected.find(ann), ann.size(), "4711,s1,al1,CS,7,\"4.00\",70.0");
    const std::string bo = "99,s2,bk1,CS,,3.5,";
    expected.replace(expected.find(bo), bo.size(), "99,s2,bk1,CS,,\"0.00\",");
    EXPECT_EQ(grades.gradebook, expected);
    EXPECT_EQ(grades.graded, (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(grades.remarks,
              (std::vector<std::string>{"maycy_100: left as it is, a person has to decide",
                                        "raydi_101: left as it is, Canvas has it as excused",
                                        "gonegus_102: no row of the gradebook fits"}));
}

TEST(CanvasGradebook, TwoSubmissionsOfOnePersonLeaveTheCellAndAreNamed) {
    const CanvasGrades grades = fillCanvasGradebook(
        kGradebook, "g.csv", "Tick 1",
        {canvasView(passedExample(), "leeann_4711"), canvasView(failedBumpExample(), "may_4711")});
    EXPECT_EQ(grades.gradebook, kGradebook);
    EXPECT_TRUE(grades.graded.empty());
    ASSERT_EQ(grades.remarks.size(), 2U);
    EXPECT_TRUE(grades.remarks[0].starts_with("leeann_4711: left out")) << grades.remarks[0];
    EXPECT_TRUE(grades.remarks[1].starts_with("may_4711: left out")) << grades.remarks[1];
}

TEST(CanvasGradebook, TakesTheAssignmentsNameHeaderOrId) {
    const std::string byName =
        fillCanvasGradebook(kGradebook, "g.csv", "Tick 1", canvasClass()).gradebook;
    for (const char* assignment : {"815", "Tick 1 (815)"})
        EXPECT_EQ(fillCanvasGradebook(kGradebook, "g.csv", assignment, canvasClass()).gradebook,
                  byName);
}

TEST(CanvasGradebook, SaysWhichAssignmentsThereAre) {
    for (const char* assignment : {"", "Tick 2"}) {
        try {
            static_cast<void>(fillCanvasGradebook(kGradebook, "g.csv", assignment, {}));
            FAIL() << assignment;
        } catch (const raytracer::InputError& error) {
            EXPECT_NE(std::string{error.what()}.find("Essay (814), Tick 1 (815)"),
                      std::string::npos)
                << error.what();
        }
    }
    EXPECT_THROW(static_cast<void>(fillCanvasGradebook("a,b\n1,2\n", "g.csv", "", {})),
                 raytracer::InputError);
}

TEST(CanvasComment, KeepsTheSourceAndCannotBeEndedEarly) {
    StudentView view = canvasView(failedBumpExample(), "kimbo_99");
    const std::string text = commentedSource(view, "int main() {}\n");
    EXPECT_TRUE(text.starts_with("/*\n")) << text;
    EXPECT_TRUE(text.ends_with("\n*/\nint main() {}\n")) << text;
    EXPECT_NE(text.find("bump.inverted-u"), std::string::npos) << text;
    EXPECT_EQ(text.find("*/"), text.rfind("*/")) << text;
}

}  // namespace
}  // namespace ticker::report
