#include <grader/report/ClassPage.h>
#include <grader/report/RepairSection.h>
#include <grader/report/ReportPage.h>
#include <grader/report/ReportWords.h>
#include <grader/report/SummaryCsv.h>

#include "ExampleResults.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

// Properties of the pages' text. Their behaviour is tested in a browser.
namespace ticker::report {
namespace {

namespace fs = std::filesystem;

std::vector<SubmissionResult> everyExample() {
    return exampleClass(5);
}

struct Tag {
    std::string name;
    std::string text;  // all between < and >
    std::string bare;  // the same without quoted parts
    bool closing = false;
};

/// All tags in order; style and script are skipped.
std::vector<Tag> scan(const std::string& html) {
    std::vector<Tag> tags;
    for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at)) {
        Tag tag;
        std::size_t end = at + 1;
        for (char quote = 0; end < html.size() && (quote != 0 || html[end] != '>'); ++end) {
            const char c = html[end];
            if (quote == 0) tag.bare += c;
            if (quote == 0 && (c == '"' || c == '\''))
                quote = c;
            else if (c == quote)
                quote = 0;
        }
        tag.text = html.substr(at + 1, end - at - 1);
        tag.closing = tag.text.front() == '/';
        const std::string named = tag.text.substr(tag.closing ? 1 : 0);
        tag.name = named.substr(0, named.find_first_of(" \n"));
        at = end;
        if (!tag.closing && (tag.name == "style" || tag.name == "script"))
            at = html.find("</" + tag.name, at);
        tags.push_back(tag);
    }
    return tags;
}

/// The opening tags of one element, each with its attributes.
std::vector<std::string> tagsOf(const std::string& html, const std::string& name) {
    std::vector<std::string> found;
    for (const Tag& tag : scan(html))
        if (tag.name == name && !tag.closing) found.push_back(tag.text);
    return found;
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

/// Expects that every element is closed, in the order of a stack.
void expectBalanced(const std::string& html) {
    static const std::set<std::string> kEmpty{"!doctype", "meta", "img", "input", "br"};
    std::vector<std::string> open;
    for (const Tag& tag : scan(html)) {
        if (kEmpty.contains(tag.name) || tag.text.back() == '/') continue;
        if (!tag.closing) {
            open.push_back(tag.name);
            continue;
        }
        ASSERT_FALSE(open.empty()) << tag.name;
        ASSERT_EQ(open.back(), tag.name);
        open.pop_back();
    }
    EXPECT_TRUE(open.empty()) << open.back();
}

void expectSelfContained(const std::string& html) {
    EXPECT_EQ(html.find("http://"), std::string::npos);
    EXPECT_EQ(html.find("https://"), std::string::npos);
    EXPECT_EQ(html.find("@import"), std::string::npos);
    EXPECT_EQ(html.find(TICKER_SOURCE_DIR), std::string::npos);
}

TEST(ReportPage, IsWellFormedAndNeedsNothingBesideIt) {
    for (const SubmissionResult& result : everyExample()) {
        SCOPED_TRACE(result.submission);
        const std::string html = reportPage(result);
        expectBalanced(html);
        expectSelfContained(html);
        EXPECT_LT(html.size(), 3'000'000U);
        for (const std::string& image : tagsOf(html, "img")) {
            EXPECT_NE(image.find("src=\"data:image/png;base64,"), std::string::npos)
                << image.substr(0, 100);
            EXPECT_NE(image.find(" alt=\""), std::string::npos) << image.substr(0, 100);
        }
    }
}

TEST(ReportPage, HasOneHeadingLandmarksAndALanguage) {
    const std::string html = reportPage(failedBumpExample());
    EXPECT_EQ(tagsOf(html, "h1").size(), 1U);
    for (const char* landmark : {"header", "main", "footer"})
        EXPECT_EQ(tagsOf(html, landmark).size(), 1U) << landmark;
    EXPECT_NE(html.find("<html lang=\"en\""), std::string::npos);
}

TEST(ReportPage, TellsMessageHintSectionAndEvidenceOfEachFinding) {
    const std::string html = reportPage(failedBumpExample());
    const Finding finding = failedBumpExample().tasks.front().findings.front();
    for (const std::string& text : {finding.id, finding.message, finding.hint, finding.section})
        EXPECT_NE(html.find(text), std::string::npos) << text;
    EXPECT_NE(html.find("208 inverted"), std::string::npos);
}

TEST(ReportPage, DrawsPlotsWithTheExpectedShape) {
    const std::string html = reportPage(failedLensExample());
    ASSERT_EQ(tagsOf(html, "svg").size(), 1U);
    EXPECT_EQ(count(tagsOf(html, "path").front(), "h0"), 600U);
    EXPECT_EQ(tagsOf(html, "rect").size(), 2U) << "two sizes are accepted";
    EXPECT_NE(tagsOf(html, "svg").front().find("600 points, across from"), std::string::npos);
}

TEST(ReportPage, ShowsTheStudentsLineUnderADiagnostic) {
    const std::string html = reportPage(blockedExample());
    EXPECT_NE(html.find("return nromal.normalised();"), std::string::npos);
    EXPECT_NE(html.find("was not declared in this scope"), std::string::npos);
}

TEST(ReportPage, LetsNothingHostileThrough) {
    const std::string html = reportPage(hostileExample());
    // The page's own, and the data of a drawing, which nothing runs.
    EXPECT_EQ(tagsOf(html, "script").size(), 2U);
    EXPECT_EQ(count(html, "</script>"), 2U);
    EXPECT_EQ(count(html, "<script type=\"application/json\">"), 1U);
    EXPECT_EQ(count(html, "</style>"), 1U);
    EXPECT_EQ(html.find("<img src=x"), std::string::npos);
    EXPECT_EQ(html.find('\x1B'), std::string::npos);
    EXPECT_EQ(html.find("\xE2\x80\xAE"), std::string::npos);
    EXPECT_EQ(html.find('\xFF'), std::string::npos);
    for (const Tag& tag : scan(html))
        EXPECT_EQ(tag.bare.find(" on"), std::string::npos) << tag.text.substr(0, 100);
}

TEST(ReportPage, RunsNoScriptButItsOwnAndLoadsNothing) {
    for (const std::string& html : {reportPage(failedBumpExample()), classPage(exampleClass(3))}) {
        const std::string policy = tagsOf(html, "meta").at(1);
        EXPECT_NE(policy.find("default-src 'none'"), std::string::npos) << policy;
        EXPECT_NE(policy.find("script-src 'sha256-"), std::string::npos) << policy;
        EXPECT_EQ(policy.find("http:"), std::string::npos) << policy;
    }
}

TEST(ReportPage, ShowsMapsBesideThePicturesAndTheScreenshotBesideWhatIsExpected) {
    const std::string html = reportPage(failedBumpExample());
    EXPECT_EQ(count(html, "<section class=\"viewer\">"), 3U) << "two scenes and the screenshot";
    EXPECT_EQ(count(html, "<figure class=\"flip\">"), 2U);
    EXPECT_EQ(count(html, "<figure class=\"expected\">"), 3U);
    EXPECT_EQ(count(reportPage(passedExample()), "<figure class=\"z\">"), 1U);
}

TEST(ReportPage, ShowsWhatWasSeenOfATaskThatPassed) {
    const std::string html = reportPage(passedExample());
    EXPECT_EQ(tagsOf(html, "svg").size(), 1U);
    EXPECT_NE(html.find("alt=\"relief that your normals show\""), std::string::npos);
}

TEST(ReportPage, LeavesPicturesThatAreTooLargeBesideThePage) {
    SubmissionResult result = failedBumpExample();
    result.pictures[1].png.resize(5'000'000);
    ASSERT_EQ(result.pictures[1].file, kScreenshotFile);
    const std::string html = reportPage(result);
    EXPECT_LT(html.size(), 3'000'000U);
    EXPECT_NE(html.find("src=\"images/screenshot.png\""), std::string::npos);
    EXPECT_EQ(html.find("src=\"images/bump-mapping.png\""), std::string::npos);
}

TEST(ReportPage, SaysFirstWhyAPersonShouldLook) {
    SubmissionResult result = failedBumpExample();
    result.verdict = Verdict::needsReview;
    result.tasks[0].needsReview = true;
    result.tasks[0].reason = "Two readings fit equally well.";
    const std::string html = reportPage(result);
    const std::size_t reason = html.find("Two readings fit equally well.");
    ASSERT_NE(reason, std::string::npos);
    EXPECT_LT(html.find("A person should look"), reason);
    EXPECT_LT(reason, html.find("<nav "));
}

TEST(ReportPage, OfAResultThatWasReadBackLinksToThePicturesBesideIt) {
    SubmissionResult result = failedBumpExample();
    for (ResultPicture& picture : result.pictures)
        picture.png.clear();
    const std::string html = reportPage(result);
    EXPECT_NE(html.find("src=\"images/bump-mapping.png\""), std::string::npos);
    EXPECT_NE(html.find("src=\"images/expected-bump-mapping.png\""), std::string::npos);
}

TEST(ClassPage, IsWellFormedAndNeedsNothingButItsFolders) {
    const std::string html = classPage(exampleClass(60));
    expectBalanced(html);
    expectSelfContained(html);
    EXPECT_EQ(tagsOf(html, "tr").size(), 61U);
    EXPECT_EQ(tagsOf(html, "h1").size(), 1U);
    EXPECT_EQ(html.find("<img src=x"), std::string::npos);
    EXPECT_EQ(count(html, "</script>"), 1U);
}

TEST(ReportPage, ShowsWhatWasNotCheckedAsThatAndNotAsPassed) {
    const std::string html = reportPage(notCheckedExample());
    EXPECT_NE(html.find("<span class=\"badge notChecked\">not checked</span>"), std::string::npos);
    EXPECT_EQ(html.find("badge passed"), std::string::npos);
    const std::string whole = classPage({notCheckedExample()});
    EXPECT_NE(whole.find("badge notChecked"), std::string::npos);
    EXPECT_EQ(whole.find("badge passed"), std::string::npos);
    const std::string summary = summaryCsv({notCheckedExample()}, {});
    EXPECT_NE(summary.find(",blocked,notAttempted,"), std::string::npos);
    EXPECT_NE(summary.find(",notChecked,"), std::string::npos);
}

TEST(ReportPage, ShowsTasksThatPassedAfterTheOthers) {
    SubmissionResult result = everyExample().front();
    result.tasks.assign(2, TaskReport{});
    result.tasks[0].id = "T2.1";
    result.tasks[1].id = "T2.2";
    result.tasks[0].state = TaskState::passed;
    result.tasks[1].state = TaskState::failed;
    const std::string html = reportPage(result);
    EXPECT_LT(html.find("<section id=\"task-T2-2\""), html.find("<section id=\"task-T2-1\""));
    result.tasks[1].state = TaskState::passed;
    const std::string right = reportPage(result);
    EXPECT_LT(right.find("<section id=\"task-T2-1\""), right.find("<section id=\"task-T2-2\""));
}

TEST(ReportPage, SaysOnceWhatIsTheSameForSeveralTasks) {
    const std::string html = reportPage(textOnlyExample());
    expectBalanced(html);
    EXPECT_EQ(count(html, "class=\"card fail\""), 1U);
    EXPECT_EQ(count(html, "The same as for <a href=\"#task-T1\">T1 Bump mapping</a>"), 3U);
    EXPECT_NE(html.find("<p class=\"lead\">Left a file out. </p>"), std::string::npos);
    EXPECT_EQ(count(classPage({textOnlyExample()}), "<li title=\"intake.missing-file\">"), 1U);
}

TEST(ReportPage, ShowsTheScreenshotsSceneWhateverTheOptionIsCalled) {
    const std::string viewer = "Submitted: screenshot.png as handed in";
    SubmissionResult result = failedBumpExample();
    const std::string usual = reportPage(result);
    ASSERT_NE(usual.find(viewer), std::string::npos);
    result.option = "bumps";
    result.options = {{"bumps", {"T1"}, 1.0}};
    const std::string html = reportPage(result);
    EXPECT_EQ(count(html, "expected-bump-mapping"), count(usual, "expected-bump-mapping"));
    EXPECT_EQ(html.substr(html.find("id=\"pictures\""), 200),
              usual.substr(usual.find("id=\"pictures\""), 200));
    EXPECT_EQ(count(html, "class=\"viewer"), count(usual, "class=\"viewer"));
}

TEST(ReportPage, NamesKeysForPicturesWhereThereAreSomeToCompare) {
    SubmissionResult result = failedBumpExample();
    EXPECT_NE(reportPage(result).find("blinks between"), std::string::npos);
    result.renders.clear();
    const std::string html = reportPage(result);
    ASSERT_NE(html.find("They explain and decide nothing"), std::string::npos);
    EXPECT_EQ(html.find("class=\"viewer\""), std::string::npos);
    EXPECT_EQ(html.find("blinks between"), std::string::npos);
}

TEST(ClassPage, SaysWithAProposalWhatWasDecided) {
    const SubmissionResult result = failedBumpExample();
    Decision decision;
    decision.submission = result.submission;
    decision.ruling = Ruling::awarded;
    const std::string html = classPage({result}, {decision});
    expectBalanced(html);
    EXPECT_NE(html.find("not awarded</span><span class=\"ruled soft\">decided: awarded</span>"),
              std::string::npos);
    decision.ruling = Ruling::notYet;
    EXPECT_NE(classPage({result}, {decision}).find(">decided: not yet<"), std::string::npos);
    decision.ruling = Ruling::undecided;
    EXPECT_EQ(classPage({result}, {decision}).find(">decided: "), std::string::npos);
}

TEST(ClassPage, SaysWhichDecisionIsAboutAnEarlierHandIn) {
    SubmissionResult result = failedBumpExample();
    result.inputs.files = "now";
    Decision decision;
    decision.submission = result.submission;
    decision.ruling = Ruling::awarded;
    decision.files = "before";
    EXPECT_NE(classPage({result}, {decision}).find(">decided: awarded, about an earlier hand-in<"),
              std::string::npos);
    decision.files = "now";
    EXPECT_NE(classPage({result}, {decision}).find(">decided: awarded<"), std::string::npos);
}

TEST(ClassPage, LinksToTheReportOfStaffAndToThePageOfTheStudent) {
    const std::string html = classPage({passedExample()});
    EXPECT_NE(html.find("href=\"Ada%20Lovelace/report.html#class\""), std::string::npos);
    EXPECT_NE(html.find("href=\"Ada%20Lovelace/student.html\""), std::string::npos);
}

TEST(ClassPage, CountsVerdictsAndFindings) {
    const std::string html = classPage(exampleClass(60));
    EXPECT_NE(html.find("<strong>36</strong> not awarded"), std::string::npos);
    EXPECT_NE(html.find("inverted the bumps along u"), std::string::npos);
    EXPECT_NE(html.find("bump.inverted-u"), std::string::npos);
    EXPECT_NE(html.find("12 of 60"), std::string::npos);
}

TEST(ClassPage, OfNobodySaysSo) {
    const std::string html = classPage({});
    expectBalanced(html);
    EXPECT_NE(html.find("0 submissions"), std::string::npos);
}

// For inspection, and for the tests in a browser.
TEST(Pages, AreWrittenToTheBuildFolderToBeLookedAt) {
    const fs::path folder = fs::path{TICKER_BINARY_DIR} / "example-pages";
    const std::vector<SubmissionResult> results = exampleClass(25);
    for (const SubmissionResult& result : results) {
        fs::create_directories(folder / result.submission / "images");
        for (const ResultPicture& picture : result.pictures)
            std::ofstream{folder / result.submission / picture.file, std::ios::binary}
                << picture.png;
        std::ofstream{folder / result.submission / "report.html"} << reportPage(result);
    }
    std::ofstream{folder / "index.html"} << classPage(results);
    EXPECT_GT(fs::file_size(folder / "index.html"), 5'000U);
}

SubmissionResult withRepair(bool proven) {
    SubmissionResult result = failedBumpExample();
    result.repairs = std::vector<Repair>{{"T1",
                                          "bump.inverted-u",
                                          "BumpySphere.cpp",
                                          {{31, "return a < b;", "return a + b;"}},
                                          proven,
                                          ""}};
    return result;
}

TEST(ReportPage, ShowsAProvenEditAsLinesBeforeAndAfter) {
    const std::string html = reportPage(withRepair(true));
    EXPECT_NE(html.find("BumpySphere.cpp, line 31"), std::string::npos);
    EXPECT_NE(html.find("return a &lt; b;</del>"), std::string::npos);
    EXPECT_NE(html.find("return a + b;</ins>"), std::string::npos);
    EXPECT_NE(html.find("passes all questions under three seeds"), std::string::npos);
}

TEST(ReportPage, ShowsOfALineThatIsLeftOutTheLineAlone) {
    SubmissionResult result = failedBumpExample();
    result.repairs = {{"T1", "bump.inverted-u", "BumpySphere.cpp", {{3, "int x;", ""}}, true, ""}};
    const std::string html = reportPage(result);
    EXPECT_EQ(tagsOf(html, "del").size(), 1U);
    EXPECT_TRUE(tagsOf(html, "ins").empty());
}

TEST(ReportPage, NeverShowsAnEditThatIsNotProven) {
    const std::string html = reportPage(withRepair(false));
    EXPECT_EQ(html.find("return a + b;"), std::string::npos);
    EXPECT_NE(html.find("No small edit of the code was found"), std::string::npos);
}

TEST(ReportPage, SaysWhereNothingWasFoundThatTheSearchEndedEarly) {
    SubmissionResult result = withRepair(true);
    result.repairs->clear();
    result.notices = {"T1: the time ended <early>.", "T2.1: of another task."};
    const std::string html = repairSection(result, result.tasks.front());
    EXPECT_NE(html.find("The time ended &lt;early&gt;."), std::string::npos) << html;
    EXPECT_EQ(html.find("of another task"), std::string::npos);
}

TEST(ReportPage, SaysThatEditsAtTwoPlacesBelongTogether) {
    SubmissionResult result = withRepair(true);
    EXPECT_EQ(reportPage(result).find("together they"), std::string::npos);
    result.repairs->front().edits.push_back({40, "b < c;", "b + c;"});
    const std::string html = reportPage(result);
    EXPECT_NE(html.find("Proven: together they pass all questions"), std::string::npos);
}

}  // namespace
}  // namespace ticker::report
