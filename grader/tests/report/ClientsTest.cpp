// Our files as read by the platforms' own code; the rules are in ClientRules.h.
#include <grader/report/platforms/PlatformFormats.h>

#include "ClientRules.h"
#include "ExampleResults.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ticker::report {
namespace {

using Names = std::vector<std::string>;

StudentView viewOf(const SubmissionResult& result) {
    return {result, {}};
}

/// All results without a mark.
std::vector<SubmissionResult> unmarkedExamples() {
    return {notGradedExample(), nothingGradedExample(), reviewExample(), textOnlyExample(),
            hostileExample()};
}

bool isNotGraded(const SubmissionResult& result) {
    return result.verdict == Verdict::notGraded;
}

TEST(Autolab, StoresNoScoreWhereThereIsNoneYet) {
    for (const SubmissionResult& result : unmarkedExamples()) {
        const tests::AutolabGrade grade = tests::readByAutolab(autolabLines(viewOf(result)));
        EXPECT_FALSE(grade.score) << result.submission;
        EXPECT_FALSE(grade.isReleased) << result.submission;
    }
    EXPECT_EQ(tests::readByAutolab(autolabLines(viewOf(passedExample()))).score, 1.0);
    EXPECT_EQ(tests::readByAutolab(autolabLines(viewOf(failedBumpExample()))).score, 0.0);
    // The effect of a missing file.
    EXPECT_EQ(tests::readByAutolab("").score, 0.0);
}

TEST(Autolab, KeepsTheColonsOfAHint) {
    SubmissionResult result = failedBumpExample();
    result.tasks[0].findings[0].hint = "BumpySphere.cpp:34:32: say raytracer::Vector3, not a:b";
    const tests::AutolabGrade grade = tests::readByAutolab(autolabLines(viewOf(result)));
    EXPECT_NE(grade.crossed.at("T1 Bump mapping")
                  .find("BumpySphere.cpp:34:32: say "
                        "raytracer::Vector3, not a:b"),
              std::string::npos);
}

TEST(Autolab, ShowsTheCompilersLinesAsLinesAndNotInACell) {
    const tests::AutolabGrade grade = tests::readByAutolab(autolabLines(viewOf(blockedExample())));
    EXPECT_NE(grade.raw.find("\n    4 |     return nromal.normalised();\n"), std::string::npos)
        << grade.raw;
    EXPECT_EQ(grade.crossed.at("T1 Bump mapping").find("nromal"), std::string::npos);
}

TEST(Autolab, MarksNothingThatWasNotChecked) {
    const auto grade = tests::readByAutolab(autolabLines(viewOf(notCheckedExample())));
    EXPECT_EQ(grade.ticked, Names{});
    EXPECT_FALSE(grade.crossed.contains("Screenshot"));
    EXPECT_NE(grade.plain.at("Screenshot").find("not checked: there is no code"),
              std::string::npos);
}

TEST(Classroom, SendsNoPointsWhereThereIsNoScoreYet) {
    for (const SubmissionResult& result : unmarkedExamples()) {
        const tests::ClassroomRun run = tests::readByClassroom(classroomJson(viewOf(result)));
        EXPECT_FALSE(run.points) << result.submission << *run.points;
        EXPECT_FALSE(run.isGreen);
    }
    EXPECT_EQ(tests::readByClassroom(classroomJson(viewOf(passedExample()))).points, "1/1");
    EXPECT_EQ(tests::readByClassroom(classroomJson(viewOf(failedLensExample()))).points, "0/1");
}

TEST(Classroom, PrintsNothingThatAStudentWrote) {
    SubmissionResult hostile = hostileExample();
    hostile.tasks[0].findings[0].message = "\n::error::Everything is lost";
    for (const Verdict verdict : {Verdict::needsReview, Verdict::notGraded, Verdict::notAwarded}) {
        hostile.verdict = verdict;
        const auto run = tests::readByClassroom(classroomJson(viewOf(hostile)));
        EXPECT_EQ(run.log.find("::error::"), std::string::npos) << run.log;
    }
}

TEST(Classroom, StudentsReadWhyInTheSummaryOfTheStep) {
    const std::string summary = classroomSummary(viewOf(failedBumpExample()));
    EXPECT_NE(summary.find("bump.inverted-u"), std::string::npos);
    EXPECT_NE(summary.find("Hint: "), std::string::npos);
    // A block of HTML ends at "</pre>" only.
    const std::string hostile = classroomSummary(viewOf(hostileExample()));
    EXPECT_TRUE(hostile.starts_with("<pre>"));
    EXPECT_EQ(hostile.find("</"), hostile.size() - std::string{"</pre>\n"}.size());
    EXPECT_EQ(hostile.find("<script"), std::string::npos);
}

TEST(PrairieLearn, HeadingNeverContradictsItself) {
    std::vector<SubmissionResult> all = exampleClass(5);
    all.push_back(notCheckedExample());
    all.push_back(saidTwiceExample());
    for (const SubmissionResult& result : all) {
        if (result.verdict == Verdict::needsReview) continue;
        const auto panel = tests::readByPrairieLearn(prairieLearnJson(viewOf(result)));
        EXPECT_EQ(panel.heading, result.verdict == Verdict::awarded ? "1/1 (100%)" : "0/1 (0%)")
            << result.submission;
        EXPECT_EQ(panel.icons.at("Tick"), result.verdict == Verdict::awarded ? "check" : "times");
        for (const auto& [name, icon] : panel.icons)
            EXPECT_TRUE(name == "Tick" || icon == "info") << name;
    }
    const auto failed = tests::readByPrairieLearn(prairieLearnJson(viewOf(failedBumpExample())));
    EXPECT_TRUE(failed.icons.contains("T1 Bump mapping: failed"));
    EXPECT_TRUE(failed.icons.contains("Screenshot: passed"));
}

TEST(PrairieLearn, CostsNoAttemptWhereThereIsNoScoreYet) {
    for (const SubmissionResult& result : unmarkedExamples())
        EXPECT_EQ(tests::readByPrairieLearn(prairieLearnJson(viewOf(result))).heading,
                  "Invalid, not gradable")
            << result.submission;
}

TEST(Gradescope, ShowsNoScoreWhereThereIsNoneYet) {
    for (const SubmissionResult& result : unmarkedExamples()) {
        const auto json = gradescopeJson(viewOf(result));
        EXPECT_EQ(json.has_value(), !isNotGraded(result)) << "a missing file is a failed grader";
        if (!json) continue;
        const tests::GradescopePage page = tests::readByGradescope(*json);
        EXPECT_FALSE(page.score) << result.submission;
        EXPECT_FALSE(page.shown.empty()) << "only the score waits";
    }
    EXPECT_EQ(tests::readByGradescope(*gradescopeJson(viewOf(failedLensExample()))).score, 0.0);
}

TEST(Gradescope, MarksNothingThatWasNotChecked) {
    const auto page = tests::readByGradescope(*gradescopeJson(viewOf(notCheckedExample())));
    EXPECT_EQ(page.ticked, Names{});
    EXPECT_EQ(page.crossed, Names{"T2.1 Soft shadows"});
    EXPECT_EQ(page.shown.size(), 2U);
}

TEST(JUnit, WritesNoFileWhereWeFailedSinceArtemisTakesAnErrorForAFailure) {
    for (const SubmissionResult& result : unmarkedExamples()) {
        const auto xml = junitXml(viewOf(result));
        EXPECT_EQ(xml.has_value(), !isNotGraded(result));
        if (!xml) continue;
        EXPECT_EQ(tests::readByJUnit(*xml).at("Tick").outcome, "skipped") << result.submission;
    }
}

TEST(JUnit, MessageIsALineAndTheTextHoldsAll) {
    auto cases = tests::readByJUnit(*junitXml(viewOf(failedBumpExample())));
    const tests::JUnitCase& failed = cases.at("T1 Bump mapping");
    EXPECT_EQ(failed.message.find('\n'), std::string::npos);
    EXPECT_TRUE(failed.message.starts_with("mistake (bump.inverted-u): ")) << failed.message;
    EXPECT_TRUE(failed.text.starts_with(failed.message));
    EXPECT_NE(failed.text.find("\nHint: "), std::string::npos);
}

TEST(JUnit, HoldsOnlyWhatJenkinsSchemaAllows) {
    for (const SubmissionResult& result : {passedExample(), failedBumpExample(), blockedExample(),
                                           hostileExample(), reviewExample()})
        EXPECT_EQ(tests::faultByJUnitSchema(*junitXml(viewOf(result))), "") << result.submission;
    EXPECT_EQ(tests::faultByJUnitSchema("<testsuites><testcase/></testsuites>"),
              "testsuites holds testcase");
    EXPECT_EQ(tests::faultByJUnitSchema("<testsuites><testsuite name='a'/></testsuites>"),
              "testsuite lacks errors");
    EXPECT_EQ(tests::faultByJUnitSchema("<testcase name='a' line='3'/>"), "testcase line");
}

TEST(JUnit, WhatIsSkippedSaysWhyInItsTextToo) {
    for (const SubmissionResult& result : {failedBumpExample(), reviewExample()})
        for (const auto& [name, read] : tests::readByJUnit(*junitXml(viewOf(result))))
            if (read.outcome == "skipped") {
                EXPECT_NE(read.text, "") << name;
            }
    EXPECT_EQ(tests::readByJUnit(*junitXml(viewOf(notCheckedExample()))).at("Screenshot").outcome,
              "skipped");
}

}  // namespace
}  // namespace ticker::report
