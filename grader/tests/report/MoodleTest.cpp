#include <grader/report/platforms/MoodleWorksheet.h>
#include <grader/tests/support/MoodleImport.h>

#include <raytracer/base/Error.h>

#include "ExampleResults.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ticker::report {
namespace {

using tests::MoodleAssignment;
using tests::MoodleStudent;
using Row = MoodleAssignment::Row;

constexpr std::time_t kNow = 1'760'000'000;

const std::vector<MoodleStudent> kStudents{
    {"Ada \"Countess\" Lovelace, jr",
     7,
     {},
     {},
     "<p>I wrote \\\"C:\\tick\\\" myself,\nhonestly</p>"},
    {"=cmd|' /C calc'!A0 O'Neill", 12, {}, {}, {}},
    {"Zo\xC3\xAB", 123, {}, {}, {}},
    {"Nobody", 9, {}, {}, {}},
};

StudentView viewOf(SubmissionResult result, const std::string& submission) {
    result.submission = submission;
    return {result, {}};
}

/// Ada passed, O'Neill failed, Zoe's code is hostile and needs a look; the fourth student handed in
/// no file.
std::vector<StudentView> someViews() {
    return {viewOf(passedExample(), "Ada Countess Lovelace, jr_7"),
            viewOf(failedBumpExample(), "=cmd_ _C calc'!A0 ONeill_12"),
            viewOf(hostileExample(), "Zo\xC3\xAB_123")};
}

MoodleAssignment assignment() {
    MoodleAssignment moodle;
    moodle.maximum = 20.0;
    moodle.records = {{7, {}}, {12, {}}, {123, {}}, {9, {}}};
    return moodle;
}

MoodleGrades filled(const std::string& worksheet, const std::vector<StudentView>& views,
                    const std::optional<ScaleWords>& scale = {}) {
    return fillMoodleWorksheet(worksheet, "sheet.csv", views, scale);
}

TEST(MoodleWorksheet, MoodleTakesEveryRowThatWasGraded) {
    MoodleAssignment moodle = assignment();
    const MoodleGrades grades = filled(moodle.worksheet(kStudents), someViews());
    EXPECT_EQ(grades.graded.size(), 2U);
    auto fared = moodle.upload(grades.worksheet, kNow);
    EXPECT_EQ(fared["Participant 7"], Row::taken);
    EXPECT_EQ(fared["Participant 12"], Row::taken);
    EXPECT_EQ(fared["Participant 123"], Row::noGrade) << "a person decides";
    EXPECT_EQ(fared["Participant 9"], Row::noGrade) << "handed nothing in";
    EXPECT_EQ(moodle.records[7].grade, "20.00");
    EXPECT_EQ(moodle.records[12].grade, "0.00");
    EXPECT_NE(moodle.records[12].feedback.find("bump.inverted-u"), std::string::npos);
    EXPECT_EQ(moodle.records[123].feedback, "");
}

TEST(MoodleWorksheet, ChangesNothingButGradeAndFeedback) {
    const std::string before = assignment().worksheet(kStudents);
    const std::string after = filled(before, someViews()).worksheet;
    const auto old = tests::readLikePhp(before);
    const auto changed = tests::readLikePhp(after);
    ASSERT_EQ(old.size(), changed.size());
    ASSERT_EQ(old[0], changed[0]);
    for (std::size_t row = 1; row < old.size(); ++row)
        for (std::size_t column = 0; column < old[0].size(); ++column)
            if (old[0][column] != "Grade" && old[0][column] != "Feedback comments") {
                EXPECT_EQ(old[row].at(column), changed[row].at(column));
            }
    EXPECT_EQ(after.substr(0, 3), "\xEF\xBB\xBF");
    EXPECT_NE(after.find("\"<p>I wrote \\\"C:\\tick\\\" myself,\nhonestly</p>\""),
              std::string::npos)
        << "quoting as it was";
    EXPECT_EQ(filled(before, {}).worksheet, before);
}

TEST(MoodleWorksheet, ASecondUploadOfAStaleWorksheetIsSkippedAndAFreshOneTaken) {
    MoodleAssignment moodle = assignment();
    const std::string stale = moodle.worksheet(kStudents);
    moodle.upload(filled(stale, someViews()).worksheet, kNow);
    const std::vector<StudentView> regraded{viewOf(passedExample(), "ONeill_12")};
    EXPECT_EQ(moodle.upload(filled(stale, regraded).worksheet, kNow + 600)["Participant 12"],
              Row::stale);
    const std::string fresh = moodle.worksheet(kStudents);
    EXPECT_EQ(moodle.upload(filled(fresh, regraded).worksheet, kNow + 600)["Participant 12"],
              Row::taken);
}

TEST(MoodleWorksheet, AScaleNeedsItsExactWords) {
    MoodleAssignment moodle = assignment();
    moodle.scale = {"Not yet", "Tick, awarded"};
    const std::string sheet = moodle.worksheet(kStudents);
    EXPECT_THROW(static_cast<void>(filled(sheet, someViews())), raytracer::InputError);
    auto fared = moodle.upload(
        filled(sheet, someViews(), ScaleWords{"Not yet", "Tick, awarded"}).worksheet, kNow);
    EXPECT_EQ(fared["Participant 7"], Row::taken);
    EXPECT_EQ(moodle.records[7].grade, "Tick, awarded");
    EXPECT_EQ(moodle.records[12].grade, "Not yet");
}

TEST(MoodleWorksheet, BlindMarkingHasNoNamesButIds) {
    MoodleAssignment moodle = assignment();
    moodle.blind = true;
    const std::vector<StudentView> views{viewOf(passedExample(), "Participant_7"),
                                         viewOf(failedLensExample(), "Participant_12")};
    auto fared = moodle.upload(filled(moodle.worksheet(kStudents), views).worksheet, kNow);
    EXPECT_EQ(fared["Participant 7"], Row::taken);
    EXPECT_EQ(fared["Participant 12"], Row::taken);
}

TEST(MoodleWorksheet, EverybodyInATeamGetsItsGradeAndNobodyElseByItsNumber) {
    MoodleAssignment moodle = assignment();
    moodle.teams = true;
    std::vector<MoodleStudent> people = kStudents;
    people[0].group = people[1].group = "Team: Red";
    people[2].group = people[3].group = "Default group";
    // The team's number is that of a participant of another team.
    const std::vector<StudentView> views{viewOf(passedExample(), "Team Red_123"),
                                         viewOf(failedBumpExample(), "Default group")};
    const MoodleGrades grades = filled(moodle.worksheet(people), views);
    moodle.upload(grades.worksheet, kNow);
    EXPECT_EQ(moodle.records[7].grade, "20.00");
    EXPECT_EQ(moodle.records[12].grade, "20.00");
    EXPECT_EQ(moodle.records[123].grade, "0.00");
    for (const NamedText& file : moodleFeedbackFiles(grades.graded, views, {"red", "default"}))
        EXPECT_TRUE(moodle.uploadFeedback(file.path)) << file.path;
    for (const auto& [id, record] : moodle.records)
        EXPECT_EQ(record.files, std::vector<std::string>{"student.html"}) << id;
}

MoodleAssignment teamsOf(std::vector<MoodleStudent>& people,
                         const std::vector<std::string>& groups) {
    MoodleAssignment moodle;
    moodle.teams = true;
    moodle.maximum = 20.0;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const int id = 101 + static_cast<int>(i);
        people.push_back({"Person " + std::to_string(id), id, groups[i], {}, {}});
        moodle.records[id] = {};
    }
    return moodle;
}

bool remarks(const MoodleGrades& grades, const std::string& name, const std::string& why) {
    return std::ranges::any_of(grades.remarks, [&](const std::string& remark) {
        return remark.starts_with(name) && remark.find(why) != std::string::npos;
    });
}

TEST(MoodleWorksheet, TeamsWhoseNamesDifferInPunctuationGetTheirOwnMarks) {
    for (const bool isPlainFirst : {true, false}) {
        std::vector<MoodleStudent> people;
        MoodleAssignment moodle = teamsOf(people, {"Team C", "Team C++"});
        std::vector<StudentView> views{viewOf(passedExample(), "Team C_11"),
                                       viewOf(failedBumpExample(), "Team C++_12")};
        if (!isPlainFirst) std::swap(views[0], views[1]);
        const MoodleGrades grades = filled(moodle.worksheet(people), views);
        moodle.upload(grades.worksheet, kNow);
        EXPECT_EQ(moodle.records[101].grade, "20.00");
        EXPECT_EQ(moodle.records[102].grade, "0.00");
        EXPECT_NE(moodle.records[102].feedback.find("bump.inverted-u"), std::string::npos);
        ASSERT_EQ(grades.graded.size(), 2U);
        EXPECT_EQ(views[grades.graded[0].view].result().submission, "Team C_11");
        EXPECT_EQ(views[grades.graded[1].view].result().submission, "Team C++_12");
        EXPECT_TRUE(grades.remarks.empty());
    }
}

TEST(MoodleWorksheet, ATeamThatHandedNothingInDoesNotGetTheMarkOfOneWithNearlyItsName) {
    for (const std::string handedIn : {"Team C", "Team C++"}) {
        std::vector<MoodleStudent> people;
        MoodleAssignment moodle = teamsOf(people, {"Team C", "Team C++"});
        const std::vector<StudentView> views{viewOf(passedExample(), handedIn + "_12")};
        const MoodleGrades grades = filled(moodle.worksheet(people), views);
        moodle.upload(grades.worksheet, kNow);
        EXPECT_EQ(moodle.records[101].grade, handedIn == "Team C" ? "20.00" : "");
        EXPECT_EQ(moodle.records[102].grade, handedIn == "Team C" ? "" : "20.00");
    }
}

TEST(MoodleWorksheet, TeamsThatMoodlesFileNamesDoNotTellApartStayEmptyAndAreNamed) {
    // Both are "Team C" in the export's file names.
    for (const std::size_t submissions : {1U, 2U}) {
        std::vector<MoodleStudent> people;
        MoodleAssignment moodle = teamsOf(people, {"Team C", "Team: C", "Red"});
        std::vector<StudentView> views{viewOf(failedBumpExample(), "Red_13"),
                                       viewOf(passedExample(), "Team C_11"),
                                       viewOf(failedLensExample(), "Team C_12")};
        views.resize(1 + submissions, views.front());
        const MoodleGrades grades = filled(moodle.worksheet(people), views);
        moodle.upload(grades.worksheet, kNow);
        EXPECT_EQ(moodle.records[101].grade, "");
        EXPECT_EQ(moodle.records[102].grade, "");
        EXPECT_EQ(moodle.records[103].grade, "0.00");
        EXPECT_EQ(grades.remarks.size(), submissions);
        EXPECT_TRUE(remarks(grades, "Team C_11", "by hand"));
    }
}

TEST(MoodleWorksheet, TwoSubmissionsOfOnePersonLeaveTheRowEmptyAndAreNamed) {
    MoodleAssignment moodle = assignment();
    const std::vector<StudentView> views{viewOf(passedExample(), "Ada Byron_7"),
                                         viewOf(failedBumpExample(), "Ada Lovelace_7")};
    const MoodleGrades grades = filled(moodle.worksheet(kStudents), views);
    moodle.upload(grades.worksheet, kNow);
    EXPECT_EQ(moodle.records[7].grade, "");
    EXPECT_TRUE(remarks(grades, "Ada Byron_7", "by hand"));
    EXPECT_TRUE(remarks(grades, "Ada Lovelace_7", "by hand"));
}

TEST(MoodleWorksheet, LeavesLockedRowsAloneAndSaysWhoIsMissing) {
    MoodleAssignment moodle = assignment();
    moodle.records[7].locked = true;
    std::vector<StudentView> views = someViews();
    views.push_back(viewOf(passedExample(), "Stranger_77"));
    const MoodleGrades grades = filled(moodle.worksheet(kStudents), views);
    EXPECT_TRUE(remarks(grades, "Ada", "locked"));
    EXPECT_TRUE(remarks(grades, "Zo\xC3\xAB", "person"));
    EXPECT_TRUE(remarks(grades, "Stranger_77", "no row"));
    EXPECT_EQ(grades.graded.size(), 1U);
}

TEST(MoodleWorksheet, FeedbackIsSafeAsHtmlAndAsCsv) {
    SubmissionResult hostile = hostileExample();
    hostile.verdict = Verdict::notAwarded;
    hostile.tasks[0].findings[0].hint += "C:\\";
    MoodleAssignment moodle = assignment();
    const std::vector<StudentView> views{viewOf(hostile, "Zo\xC3\xAB_123")};
    auto fared = moodle.upload(filled(moodle.worksheet(kStudents), views).worksheet, kNow);
    EXPECT_EQ(fared["Participant 123"], Row::taken);
    const std::string& feedback = moodle.records[123].feedback;
    EXPECT_EQ(feedback.find("<script"), std::string::npos);
    EXPECT_NE(feedback.find("&lt;script"), std::string::npos);
    EXPECT_EQ(feedback.find_first_of("=+-@"), feedback.find_first_of("=+-@", 1))
        << "begins like no formula";
}

TEST(MoodleWorksheet, AnotherFileIsRefusedWithTheColumnThatItLacks) {
    try {
        static_cast<void>(filled("Name,Grade\nx,1\n", {}));
        FAIL();
    } catch (const raytracer::InputError& error) {
        EXPECT_NE(std::string{error.what()}.find("Identifier"), std::string::npos);
    }
}

bool warns(const MoodleGrades& grades, const std::string& words) {
    return std::ranges::any_of(grades.warnings, [&](const std::string& warning) {
        return warning.find(words) != std::string::npos;
    });
}

TEST(MoodleWorksheet, WarnsOfZerosWhichTheNewestMoodleDropsAndAScaleKeeps) {
    MoodleAssignment moodle = assignment();
    moodle.dropsZeros = true;
    const MoodleGrades points = filled(moodle.worksheet(kStudents), someViews());
    EXPECT_EQ(moodle.upload(points.worksheet, kNow)["Participant 12"], Row::noGrade);
    EXPECT_TRUE(warns(points, "1 of the marks is 0"));
    EXPECT_TRUE(warns(points, "--scale"));

    moodle.scale = {"Not yet", "Tick"};
    const MoodleGrades words =
        filled(moodle.worksheet(kStudents), someViews(), ScaleWords{"Not yet", "Tick"});
    EXPECT_EQ(moodle.upload(words.worksheet, kNow)["Participant 12"], Row::taken);
    EXPECT_FALSE(warns(words, "marks"));
    EXPECT_FALSE(warns(filled(assignment().worksheet(kStudents),
                              {viewOf(passedExample(), "Ada Countess Lovelace, jr_7")}),
                       "marks"));
}

TEST(MoodleWorksheet, WarnsOfDatesThatAreNotInEnglish) {
    MoodleAssignment moodle = assignment();
    moodle.records[12].gradedAt = kNow;
    std::string sheet = moodle.worksheet(kStudents);
    EXPECT_FALSE(warns(filled(sheet, someViews()), "English"));
    const std::string date = tests::moodleDate(kNow);
    sheet.replace(sheet.find(date), date.size(), "Donnerstag, 9. Oktober 2025, 08:53");
    EXPECT_TRUE(warns(filled(sheet, someViews()), "switch Moodle to English"));
}

TEST(MoodleWorksheet, RefusesARowThatABackslashBreaksForMoodle) {
    std::vector<MoodleStudent> people = kStudents;
    people.push_back({"Eve \\", 5, {}, {}, {}});
    try {
        static_cast<void>(filled(assignment().worksheet(people), someViews()));
        FAIL();
    } catch (const raytracer::InputError& error) {
        EXPECT_NE(std::string{error.what()}.find("a field that ends in a backslash"),
                  std::string::npos)
            << error.what();
    }
}

TEST(MoodleWorksheet, RefusesWhatExcelSavedAndSaysWhatToHandIn) {
    for (const std::string& sheet : {std::string{"\xFF\xFEI\0d\0", 6},
                                     std::string{"Identifier;Full name;Grade\nParticipant 7;A;\n"},
                                     std::string{"Identifier\tGrade\nParticipant 7\t\n"}}) {
        try {
            static_cast<void>(filled(sheet, {}));
            FAIL() << sheet;
        } catch (const raytracer::InputError& error) {
            EXPECT_NE(std::string{error.what()}.find("as Moodle's download, untouched"),
                      std::string::npos)
                << error.what();
        }
    }
}

TEST(MoodleFeedbackFiles, OlderMoodleFindsThemToo) {
    MoodleAssignment moodle = assignment();
    moodle.wantsFiveParts = true;
    for (const NamedText& file : moodleFeedbackFiles({{"7", 0}}, someViews(), {"a"}))
        EXPECT_TRUE(moodle.uploadFeedback(file.path)) << file.path;
    EXPECT_FALSE(moodle.uploadFeedback("Ada_7_assignsubmission_file/student.html"));
}

TEST(MoodleFeedbackFiles, MoodleFindsEverybodyWhateverTheName) {
    MoodleAssignment moodle = assignment();
    const std::vector<StudentView> views = someViews();
    const auto files =
        moodleFeedbackFiles({{"7", 0}, {"12", 1}, {"123", 2}}, views, {"a", "b", "c"});
    ASSERT_EQ(files.size(), 3U);
    for (const NamedText& file : files)
        EXPECT_TRUE(moodle.uploadFeedback(file.path)) << file.path;
    EXPECT_EQ(moodle.records[12].files, std::vector<std::string>{"student.html"});
}

}  // namespace
}  // namespace ticker::report
