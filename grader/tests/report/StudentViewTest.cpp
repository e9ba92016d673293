#include <grader/report/Markdown.h>
#include <grader/report/ReportPage.h>
#include <grader/report/platforms/MoodleFeedback.h>
#include <grader/report/platforms/PlatformFormats.h>
#include <grader/report/student/StudentPage.h>
#include <grader/report/student/StudentView.h>

#include <grader/result/AppealNumber.h>

#include <raytracer/base/Error.h>

#include "ExampleResults.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace ticker::report {
namespace {

namespace fs = std::filesystem;

const fs::path kPolicy{TICKER_SOURCE_DIR "/grader/report/student-view.json"};

/// All output for students about a result.
std::string everythingShown(const SubmissionResult& result, const StudentPolicy& policy) {
    const StudentView view{result, policy};
    return gradescopeJson(view).value_or("") + prairieLearnJson(view) + classroomJson(view) +
           autolabLines(view) + junitXml(view).value_or("") + classroomSummary(view) +
           wholeText(view) + studentPage(view);
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string errorOf(const std::string& text) {
    const fs::path file = fs::path{testing::TempDir()} / "view.json";
    std::ofstream{file} << text;
    try {
        static_cast<void>(readStudentPolicy(file));
        return "";
    } catch (const raytracer::InputError& error) {
        return error.what();
    }
}

TEST(StudentView, HoldsNoSeedNoExpectedPictureAndNoMeasuredValue) {
    SubmissionResult result = failedBumpExample();
    result.seed = 987654321;
    result.tasks[0].findings[0].evidence = {{"hiddenQuestion", std::string{"latitude 12.5"}}};
    const std::string shown = everythingShown(result, readStudentPolicy(kPolicy));
    EXPECT_TRUE(holds(shown, "bump.inverted-u")) << "the test must look at something";
    EXPECT_FALSE(holds(shown, "987654321"));
    EXPECT_FALSE(holds(shown, "latitude 12.5"));
    EXPECT_FALSE(holds(shown, "Signed tilt")) << "a map of what was asked";
    EXPECT_FALSE(holds(shown, "expected-bump-mapping"));
    EXPECT_FALSE(holds(shown, "bump-mapping, expected"));
    EXPECT_TRUE(holds(shown, "bump-mapping, from your code"));
}

TEST(StudentView, KeepsToItselfWhyWeFailed) {
    SubmissionResult result = failedBumpExample();
    result.verdict = Verdict::notGraded;
    result.tasks[0].state = TaskState::notGraded;
    result.tasks[0].reason = "cannot write /srv/secret/probe";
    result.tasks[0].findings.clear();
    EXPECT_FALSE(holds(everythingShown(result, {}), "/srv/secret"));
}

TEST(StudentView, SaysFirstThatATickerDecidedAgainstTheCheckAndWhy) {
    SubmissionResult overruled = failedBumpExample();
    overruled.verdict = Verdict::awarded;
    const StudentView tick{overruled, {}, "shown at the desk", Verdict::notAwarded};
    EXPECT_EQ(verdictText(tick),
              "Tick awarded by your ticker, against the automatic check. What the check says below "
              "does not take it back.\nYour ticker says: shown at the desk");
    SubmissionResult refused = passedExample();
    refused.verdict = Verdict::notAwarded;
    EXPECT_EQ(verdictText(StudentView{refused, {}, "copied", Verdict::awarded}),
              "No tick yet. Your ticker decided so, although the automatic check below passed.\n"
              "Your ticker says: copied");
    EXPECT_EQ(verdictText(StudentView{overruled, {}, "", Verdict::needsReview}), "Tick awarded.")
        << "nothing was proposed";
}

TEST(StudentView, ShowsWhatThePolicyAllowsAndNoMore) {
    StudentPolicy policy;
    policy.evidence = {"uInverted"};
    const SubmissionResult failed = failedBumpExample();
    const std::string hint = failed.tasks[0].findings[0].hint.substr(0, 20);
    EXPECT_TRUE(holds(everythingShown(failed, policy), hint));
    EXPECT_TRUE(holds(everythingShown(failed, policy), "0.98"));
    policy = {.hints = false, .ownPictures = false, .evidence = {}};
    EXPECT_FALSE(holds(everythingShown(failed, policy), hint));
    EXPECT_FALSE(holds(everythingShown(failed, policy), "<figure"));

    EXPECT_TRUE(holds(everythingShown(blockedExample(), {}), "nromal"));
    EXPECT_FALSE(holds(everythingShown(blockedExample(), {.compilerOutput = false, .evidence = {}}),
                       "nromal"));
    EXPECT_TRUE(holds(everythingShown(passedExample(), {}), "shadow.clustered"));
    EXPECT_FALSE(
        holds(everythingShown(passedExample(), {.warnings = false, .evidence = {}}), "clustered"));
}

TEST(StudentView, HoldsWhatThePersonSaidWhoDecided) {
    const StudentView view{failedBumpExample(), {}, "Come and see me\x1B, <Ada>"};
    EXPECT_TRUE(holds(*gradescopeJson(view), "Come and see me"));
    EXPECT_TRUE(holds(studentPage(view), "&lt;Ada&gt;"));
    EXPECT_FALSE(holds(verdictText(view), "\x1B"));
}

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

TEST(StudentView, SaysOnceWhatIsTheSameForSeveralTasks) {
    const StudentView nothing{textOnlyExample(), {}};
    EXPECT_EQ(countOf(wholeText(nothing), "There is a text, but no file."), 1U);
    EXPECT_TRUE(holds(wholeText(nothing),
                      "T1 Bump mapping, T2.1 Soft shadows, T2.2 Depth of field and Screenshot, "
                      "blocked\n"));
    EXPECT_EQ(countOf(studentPage(nothing), "There is a text, but no file."), 1U);
    EXPECT_EQ(countOf(*gradescopeJson(nothing), "There is a text, but no file."), 1U);
    EXPECT_EQ(countOf(*gradescopeJson(nothing), "The same as for T1 Bump mapping."), 3U);

    const StudentView twice{saidTwiceExample(), {}};
    EXPECT_EQ(countOf(wholeText(twice), "Renderer.cpp:7:3: error"), 1U);
    EXPECT_TRUE(holds(wholeText(twice), "T2.1 Soft shadows and T2.2 Depth of field, blocked\n"));
    EXPECT_EQ(countOf(wholeText(StudentView{nothingGradedExample(), {}}), "not yours"), 2U)
        << "of the verdict, and of the tasks";
}

TEST(StudentView, DoesNotSayTwiceThatATaskPassed) {
    const std::string text = wholeText(StudentView{passedExample(), {}});
    EXPECT_TRUE(holds(text, "T1 Bump mapping, passed\n\nT2.1")) << text;
}

TEST(StudentView, TellsTheRuleOfTheRubric) {
    SubmissionResult result = failedBumpExample();
    const auto told = [&] { return verdictText(StudentView{result, {}}); };
    EXPECT_EQ(told(), "No tick yet. One option is enough: T1, or T2.1 and T2.2 together.");
    result.options = {{"all of it", {"T1", "T2.1", "T2.2"}, 1.0}};
    EXPECT_EQ(told(), "No tick yet. It takes T1, T2.1 and T2.2 together.");
    result.options = {{"a", {"T1"}, 1.0}, {"b", {"T2.1"}, 1.0}, {"c", {"T2.2"}, 1.0}};
    EXPECT_EQ(told(), "No tick yet. One option is enough: T1, or T2.1, or T2.2.");
    result.options.clear();
    EXPECT_EQ(told(), "No tick yet.") << "a result of an older ticker";
    for (TaskReport& task : result.tasks)
        task = {{TaskState::notAttempted, "", {}}, task.id, task.title};
    result.options = {{"lens", {"T2.1", "T2.2"}, 1.0}};
    EXPECT_EQ(told(), "No tick yet: no task was worked on. Edit Renderer.cpp (T2.1 and T2.2).");
}

TEST(StudentView, TextHasNoControlCharacter) {
    for (const char c : wholeText(StudentView{hostileExample(), {}}))
        EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t');
}

TEST(StudentPage, LetsNoMarkupOfAStudentThrough) {
    const std::string page = studentPage(StudentView{hostileExample(), {}});
    EXPECT_FALSE(holds(page, "<script>alert"));
    EXPECT_FALSE(holds(page, "<img src=x"));
}

TEST(StudentPolicy, AFileThatForgetsAMemberOrInventsOneIsRefused) {
    EXPECT_NE(errorOf("{}").find("expected a member"), std::string::npos);
    EXPECT_NE(errorOf("[]").find("object"), std::string::npos);
    EXPECT_NE(errorOf("{").find("not JSON"), std::string::npos);
    EXPECT_NE(errorOf("{\n  \"hints\": maybe\n}").find("view.json:2: not JSON"), std::string::npos);
    std::ifstream stream{kPolicy};
    std::string text{std::istreambuf_iterator<char>{stream}, {}};
    EXPECT_EQ(errorOf(text), "");
    const std::size_t brace = text.find('{') + 1;
    EXPECT_NE(errorOf(std::string{text}.insert(brace, "\"seed\": true,")).find("/seed"),
              std::string::npos);
    EXPECT_NE(errorOf(text.replace(text.find("true"), 4, "1"))
                  .find("view.json:2: /hints: expected true or false"),
              std::string::npos);
}

TEST(StudentView, ShowsTheTickersWordsAsMarkdownAndBesideTheLines) {
    SubmissionResult result = passedExample();
    const std::vector<LineNote> notes{{"Own.cpp", 7, "a < b;", "`<` is **right**"}};
    const StudentView view{result, {}, "See \\ `x`\nand <script>", {}, notes};
    const std::string page = studentPage(view);
    EXPECT_TRUE(holds(page, "See \\ <code>x</code><br />\nand &lt;script&gt;")) << page;
    EXPECT_TRUE(holds(page, "<h3>Own.cpp, line 7</h3>")) << page;
    EXPECT_TRUE(holds(page, "   7</span> a &lt; b;"));
    EXPECT_TRUE(holds(page, "<p><code>&lt;</code> is <strong>right</strong></p>"));
    EXPECT_TRUE(holds(verdictText(view), "About Own.cpp, line 7: a < b;\n`<` is **right**"));
    const std::string feedback = moodleFeedback(view);
    EXPECT_TRUE(
        holds(feedback, "<blockquote><p>See &#92; <code>x</code><br />and &lt;script&gt;</p>"))
        << feedback;
    EXPECT_TRUE(holds(feedback, "<p>About Own.cpp, line 7:</p><pre>a &lt; b;</pre>")) << feedback;
    for (const char* bad : {"\n", "\"", "\\"})
        EXPECT_FALSE(holds(feedback, bad)) << bad;
}

TEST(StudentView, TellsTheNumberOfTheResultAndNotItsSeed) {
    SubmissionResult result = passedExample();
    const std::string number = appealNumber(result);
    EXPECT_EQ(number.size(), 9U);
    EXPECT_TRUE(holds(studentPage(StudentView{result, {}}), "number: " + number + "<"));
    EXPECT_TRUE(holds(reportPage(result), number));
    ++result.seed;
    EXPECT_NE(appealNumber(result), number);
}

TEST(Markdown, TakesMarkupForTextAndHeadingsForParagraphs) {
    EXPECT_EQ(markdownHtml("# std::vector<int> x"), "<p>std::vector&lt;int&gt; x</p>\n");
    EXPECT_EQ(markdownHtml("<b>\nx</b>"), "<p>&lt;b&gt;\nx&lt;/b&gt;</p>\n");
    EXPECT_EQ(markdownHtml("![dot](http://x.example/y.png)"), "<p>dot</p>\n");
    EXPECT_EQ(markdownHtml("[x](javascript:y)"), "<p><a href=\"\">x</a></p>\n");
    EXPECT_EQ(markdownHtml(""), "");
}

TEST(StudentView, ShowsTheStudentsOwnRaysAndNoOther) {
    SubmissionResult result = failedLensExample();
    for (TaskReport& task : result.tasks)
        for (Finding& finding : task.findings)
            for (ScatterPlot& plot : finding.plots)
                plot.title = "a plot of what was asked";
    StudentPolicy policy = readStudentPolicy(kPolicy);
    const std::string shown = studentPage(StudentView{result, policy});
    EXPECT_TRUE(holds(shown, "a camera ray")) << "the test must look at something";
    EXPECT_FALSE(holds(shown, "the expected ray"));
    EXPECT_FALSE(holds(shown, "a plot of what was asked"));
    policy.rays = false;
    EXPECT_FALSE(holds(studentPage(StudentView{result, policy}), "a camera ray"));
}

TEST(StudentView, ShowsTheStudentsOwnNormalsAndNoneThatWasExpected) {
    SubmissionResult result = failedBumpExample();
    RayDrawing drawing;
    drawing.about = "normals of one row";
    drawing.normals = {
        {{0.0, 0.0, 2.8}, {0.0, 0.0, -1.0}, {{0.1234, 0.0, -0.9}}, {0.4321, 0.0, -0.9}}};
    ScatterPlot plot;
    plot.drawing = drawing;
    result.tasks[0].findings[0].plots = {plot};
    const std::string shown = studentPage(StudentView{result, readStudentPolicy(kPolicy)});
    EXPECT_TRUE(holds(shown, "0.4321")) << "the test must look at something";
    EXPECT_FALSE(holds(shown, "0.1234"));
    EXPECT_TRUE(holds(reportPage(result), "0.1234")) << "a ticker sees it";
}

Repair repairIn(int line, bool proven) {
    return {"T1",
            "bump.inverted-u",
            "BumpySphere.cpp",
            {{line, "    return a - b;", "    return a + b;"}},
            proven,
            ""};
}

SubmissionResult withRepairs(std::vector<Repair> repairs) {
    SubmissionResult result = failedBumpExample();
    result.repairs = std::move(repairs);
    return result;
}

TEST(StudentView, SaysTheLineButNotTheEditWhereAllProvenEditsAgree) {
    const StudentPolicy policy = readStudentPolicy(kPolicy);
    const std::string shown =
        everythingShown(withRepairs({repairIn(31, true), repairIn(31, true)}), policy);

    EXPECT_TRUE(holds(shown, "An edit in line 31 of BumpySphere.cpp mends this."));
    EXPECT_FALSE(holds(shown, "a + b"));
}

TEST(StudentView, SaysNoLineWhereProvenEditsDisagree) {
    const StudentPolicy policy = readStudentPolicy(kPolicy);
    EXPECT_FALSE(
        holds(everythingShown(withRepairs({repairIn(31, true), repairIn(12, true)}), policy),
              "An edit in line"));
}

TEST(StudentView, SaysNoLineOfAnEditThatIsNotProven) {
    const StudentPolicy policy = readStudentPolicy(kPolicy);
    EXPECT_FALSE(
        holds(everythingShown(withRepairs({repairIn(31, false)}), policy), "An edit in line"));
}

TEST(StudentView, SaysNoLineWhereThePolicyIsOff) {
    StudentPolicy policy = readStudentPolicy(kPolicy);
    policy.repairs = StudentPolicy::Repairs::off;
    EXPECT_FALSE(
        holds(everythingShown(withRepairs({repairIn(31, true)}), policy), "An edit in line"));
}

}  // namespace
}  // namespace ticker::report
