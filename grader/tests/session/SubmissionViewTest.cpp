#include "ClassOnDisk.h"

#include <grader/session/CodeView.h>
#include <grader/session/SubmissionView.h>

#include <gtest/gtest.h>

#include <fstream>

namespace ticker::session {
namespace {

TEST(SubmissionHtml, ShowsFindingsAndCodeAndEscapesThem) {
    const std::string name = "O'Neill \"<script>name</script>\"";
    const tests::ClassOnDisk onDisk{{"bob"}};
    SubmissionResult result = tests::markedResult(name, Verdict::needsReview);
    result.renders.push_back(
        {"bump-mapping", 1, 1, 0, 0, 0, 0, 0, "images/a.png", "images/b.png", ""});
    const std::string html = submissionHtml(result, onDisk.out() / "bob" / "code");
    EXPECT_EQ(html.find("<script"), std::string::npos) << html;
    for (const char* part : {"name", "reason", "message", "hint", "evidence", "notice", "code"})
        EXPECT_NE(html.find(std::string{"&lt;script&gt;"} + part), std::string::npos) << part;
    EXPECT_NE(html.find("bump.inverted-u"), std::string::npos);
    EXPECT_NE(html.find("<i class=\"k\">int</i> x;"), std::string::npos);
    EXPECT_NE(html.find("src=\"of/O%27Neill%20%22%3Cscript%3Ename%3C"), std::string::npos) << html;
}

TEST(SubmissionHtml, PutsTheCompilersWordsBesideTheStudentsLine) {
    const tests::ClassOnDisk onDisk{{"bob"}};
    SubmissionResult result = tests::markedResult("bob", Verdict::notAwarded);
    result.diagnostics.push_back(
        {"BumpySphere.cpp", "BumpySphere.cpp:1:5: error: expected initializer before 'x'\n"});
    const std::string html = submissionHtml(result, onDisk.out() / "bob" / "code");
    EXPECT_NE(html.find("line 1: expected initializer"), std::string::npos);
    EXPECT_NE(html.find("<mark><span class=\"number\">   1</span> int x; // &lt;script&gt;"),
              std::string::npos)
        << html;
    EXPECT_NE(html.find("<span class=\"line error\" data-line=\"1\">"), std::string::npos) << html;
    EXPECT_NE(html.find("<span class=\"said error\">error: expected initializer before &#39;x"),
              std::string::npos)
        << html;
}

TEST(CodeHtml, SaysOfALineWhatPointsAtIt) {
    const std::vector<SourceText> sources{{"Own.cpp", "int a;\nint b;\n"}};
    const std::string html = codeHtml(sources, {{"Own.cpp", 2, "proven", "<b> makes it pass"},
                                                {"Other.cpp", 1, "error", "elsewhere"}});
    EXPECT_NE(html.find("<span class=\"line\" data-line=\"1\">"), std::string::npos) << html;
    EXPECT_NE(html.find("<span class=\"line proven\" data-line=\"2\">"), std::string::npos) << html;
    EXPECT_NE(html.find("<span class=\"said proven\">&lt;b&gt; makes it pass</span>"),
              std::string::npos)
        << html;
    EXPECT_EQ(html.find("elsewhere"), std::string::npos);
    EXPECT_EQ(codeHtml({}, {}), "");
}

TEST(SubmissionHtml, SaysAtItsHeadThatItWasHandedInBeforeAndShowsWhatHasChanged) {
    const tests::ClassOnDisk onDisk{{"bob"}};
    const std::filesystem::path before = onDisk.out() / "before";
    std::filesystem::create_directories(before);
    std::ofstream{before / "BumpySphere.cpp"} << "int old;\n";
    SubmissionResult now = tests::markedResult("bob", Verdict::awarded);
    for (TaskReport& task : now.tasks)
        task.findings.clear();
    const std::vector<store::Earlier> earlier{
        {tests::markedResult("bob", Verdict::notAwarded), before, "2026-11-21T16:05:36Z"}};
    const std::string html = submissionHtml(now, onDisk.out() / "bob" / "code", earlier);
    const std::size_t line = html.find("Handed in before: ");
    EXPECT_LT(line, html.find("<section"));
    EXPECT_LT(html.find("No longer found: <code>bump.inverted-u</code>"), html.find("<section"));
    EXPECT_NE(html.find("<span class=\"diff out\">- int old;</span>"), std::string::npos) << html;
    EXPECT_NE(html.find("<span class=\"diff in\">+ int x;"), std::string::npos) << html;
    const std::string first = submissionHtml(now, onDisk.out() / "bob" / "code");
    EXPECT_EQ(first.find("Handed in before"), std::string::npos);
}

TEST(SubmissionHtml, MarksTheLineOfAProvenEditInTheCode) {
    const tests::ClassOnDisk onDisk{{"bob"}};
    SubmissionResult result = tests::markedResult("bob", Verdict::notAwarded);
    result.repairs = {
        {"T1", "bump.inverted-u", "BumpySphere.cpp", {{1, "int x;", "int <y>;"}}, true, ""}};
    const std::string html = submissionHtml(result, onDisk.out() / "bob" / "code");
    EXPECT_NE(html.find("<span class=\"line proven\" data-line=\"1\">"), std::string::npos) << html;
    EXPECT_NE(html.find("<span class=\"said proven\">T1 passes with: int &lt;y&gt;;</span>"),
              std::string::npos)
        << html;
}

TEST(SubmissionHtml, SaysAReasonOnlyWhereNoFindingSaysIt) {
    const tests::ClassOnDisk onDisk{{"bob"}};
    SubmissionResult result = tests::markedResult("bob", Verdict::notAwarded);
    TaskReport& task = result.tasks.at(0);
    task.reason = task.findings.at(0).message = "it does not compile";
    const std::filesystem::path code = onDisk.out() / "bob" / "code";
    EXPECT_EQ(submissionHtml(result, code).find("<p>It does not compile</p>"), std::string::npos);
    EXPECT_EQ(submissionHtml(result, code).find("<p>it does not compile</p>"), std::string::npos);
    task.reason = "why it is in doubt";
    EXPECT_NE(submissionHtml(result, code).find("<p>Why it is in doubt</p>"), std::string::npos);
}

TEST(SubmissionHtml, SaysOfALineThatIsLeftOutWhatPassesWithoutIt) {
    const tests::ClassOnDisk onDisk{{"bob"}};
    SubmissionResult result = tests::markedResult("bob", Verdict::notAwarded);
    result.repairs = {{"T1", "bump.inverted-u", "BumpySphere.cpp", {{1, "int x;", ""}}, true, ""}};
    const std::string html = submissionHtml(result, onDisk.out() / "bob" / "code");
    EXPECT_NE(html.find("T1 passes without this line<"), std::string::npos) << html;
}

TEST(SubmissionHtml, NamesTheOtherLineOfAnEditAtTwoPlaces) {
    const tests::ClassOnDisk onDisk{{"bob"}};
    SubmissionResult result = tests::markedResult("bob", Verdict::notAwarded);
    result.repairs = {{"T1",
                       "bump.inverted-u",
                       "BumpySphere.cpp",
                       {{1, "int x;", "int y;"}, {7, "int a;", "int b;"}},
                       true,
                       ""}};
    const std::string html = submissionHtml(result, onDisk.out() / "bob" / "code");
    EXPECT_NE(html.find("T1 passes with this and line 7: int y;"), std::string::npos) << html;
}

TEST(SubmissionHtml, ShowsWhatAnotherHandInChanged) {
    const tests::ClassOnDisk onDisk{{"bob", "old"}};
    SubmissionResult before = tests::markedResult("bob", Verdict::needsReview);
    before.tasks.at(0).findings.at(0).id = "bump.flat";
    const std::filesystem::path code = onDisk.out() / "bob" / "code";
    std::ofstream{onDisk.out() / "old/code/BumpySphere.cpp"} << "int y;\n";
    const std::string html =
        submissionHtml(tests::markedResult("bob", Verdict::notAwarded), code,
                       {{before, onDisk.out() / "old/code", "2026-11-21T16:05:36Z"}});
    for (const char* part :
         {"<time datetime=\"2026-11-21T16:05:36Z\">", "No longer found: <code>bump.flat</code>.",
          "New: <code>bump.inverted-u</code>.", "<span class=\"diff out\">- int y;</span>",
          "<span class=\"diff in\">+ int x; // &lt;script&gt;code"})
        EXPECT_NE(html.find(part), std::string::npos) << part;
    EXPECT_EQ(submissionHtml(before, code).find("Handed in before"), std::string::npos);
}

// What is no text blocks both tasks of its file for one reason.
TEST(SubmissionHtml, SaysOnceWhatBlocksTwoTasks) {
    const tests::ClassOnDisk onDisk{{"bob"}};
    SubmissionResult result = tests::markedResult("bob", Verdict::notAwarded);
    TaskReport& first = result.tasks.front();
    first.title = "Soft <shadows>";
    first.reason = first.findings.at(0).message = "Renderer.cpp is no plain text";
    TaskReport second = first;
    second.id = "T2.2";
    second.title = "Depth of field";
    result.tasks.push_back(second);
    const std::filesystem::path code = onDisk.out() / "bob" / "code";
    const std::string same = "<p>The same as for Soft &lt;shadows&gt;.</p></section>";
    const auto cards = [](const std::string& html) {
        std::size_t count = 0;
        for (std::size_t at = html.find("hint&lt;"); at != std::string::npos;
             at = html.find("hint&lt;", at + 1))
            ++count;
        return count;
    };
    const std::string once = submissionHtml(result, code);
    EXPECT_NE(once.find(same), std::string::npos) << once;
    EXPECT_EQ(once.find(same), once.rfind("The same as for") - 3);
    EXPECT_EQ(cards(once), 1U) << once;
    result.tasks.back().findings.at(0).message = "something else";
    const std::string twice = submissionHtml(result, code);
    EXPECT_EQ(twice.find("The same as for"), std::string::npos) << twice;
    EXPECT_EQ(cards(twice), 2U) << twice;
}

TEST(SubmissionHtml, SaysAboveThePicturesOnceWhatStandsUnderSeveralTasks) {
    const tests::ClassOnDisk onDisk{{"bob"}};
    SubmissionResult result = tests::markedResult("bob", Verdict::notAwarded);
    result.tasks.push_back(result.tasks.front());
    const std::string html = submissionHtml(result, onDisk.out() / "bob" / "code");
    const std::string told = html.substr(0, html.find("</ul>"));
    EXPECT_NE(told.find("<li>"), std::string::npos);
    EXPECT_EQ(told.find("<li>"), told.rfind("<li>"));
}

}  // namespace
}  // namespace ticker::session
