// Statements of the documents, most of them about other programs, whose loss no other test would
// notice. Whoever rewrites a document keeps them, or changes them here as well.
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

namespace ticker {
namespace {

/// A document without its line breaks.
std::string inOneLine(const std::string& document) {
    static const std::regex kBlanks{R"(\s+)"};
    return std::regex_replace(tests::readFile(document), kBlanks, " ");
}

struct Statements {
    std::string document;
    std::vector<std::string> phrases;
};

void expectToFind(const std::vector<Statements>& wanted) {
    for (const auto& [document, phrases] : wanted) {
        const std::string text = inOneLine(document);
        for (const std::string& phrase : phrases)
            EXPECT_NE(text.find(phrase), std::string::npos)
                << document << " no longer says: " << phrase;
    }
}

TEST(Documents, KeepWhatPreventsLostGrades) {
    expectToFind(
        {{"docs/platforms.md",
          {// Moodle's worksheet
           // NOLINTNEXTLINE(bugprone-suspicious-missing-comma): long sentences take two lines
           "Upload `OUT/moodle-worksheet.csv` (separator: comma), **then** "
           "`OUT/moodle-feedback.zip`",
           "Switch Moodle to English for the download and the upload of the worksheet",
           "silently skips the rows whose dates it cannot read",
           "Moodle cannot read it after Excel has saved it",
           "**Download a fresh worksheet before every upload**, and upload it before the zip.",
           "tick *Allow updating records that have been modified more recently in Moodle than in "
           "the spreadsheet* on the upload page",
           "The newest Moodle drops a grade of 0",
           // Gradescope
           "set the assignment's *Autograder points* to the rubric's `maxScore`, which is 1",
           // Autolab
           "The last line must contain a score, or `null`: without it Autolab stores a 0",
           // A score that is not there yet
           "**A missing score is not a zero.** A submission has no score while a ticker has",
           "| | a ticker decides | not graded |",
           "| Autolab | `null`: the problem stays ungraded | the same |",
           "| Classroom | no points are sent; the run is red, with one sentence | the same |",
           "| Gradescope | the score stays hidden until you publish grades; the tests are visible "
           "| no file: \"the autograder failed\" |",
           "| PrairieLearn | \"Invalid, not gradable\", with the findings; costs no attempt | the "
           "same, without findings |",
           "| JUnit | \"Tick\" is skipped | no file: let the job fail (exit status 3) |",
           "| Moodle | the row stays as it is | the same |",
           "| Canvas | the cell stays as it is | the same |"}}});
}

TEST(Documents, KeepWhichPageIsForWhom) {
    expectToFind(
        {{"docs/platforms.md",
          {"`student.html` is the student's page. `report.html` is for staff: it contains the "
           "seed, the expected pictures and the measured values.",
           "| `html` | `OUT/index.html`, `OUT/<submission>/report.html` | staff |",
           "| | `OUT/<submission>/student.html` | the student |"}},
         {"docs/for-tickers.md",
          {"out/class/<submission>/report.html for staff: with the seed, the expected pictures and "
           "all measured values",
           "out/class/<submission>/student.html for the student, with your decision once the "
           "session has ended"}}});
}

}  // namespace
}  // namespace ticker
