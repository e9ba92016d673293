#ifndef TICKER_TESTS_REPORT_CLIENTRULES_H
#define TICKER_TESTS_REPORT_CLIENTRULES_H

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::tests {

// How each platform reads our file, by the rules of its own code. Rules are facts; the code here is
// ours. Moodle's importer is in grader/tests/support/MoodleImport.h.

/// Autolab 9cc857f (saveAutograde, parseFeedback, _semantic.html.erb).
struct AutolabGrade {
    std::optional<double> score;      ///< of the problem "Tick"; empty: the problem stays ungraded
    bool isReleased = false;          ///< the student sees a score
    std::vector<std::string> ticked;  ///< rows with a green tick
    std::map<std::string, std::string> crossed;  ///< rows with a red mark, and their hint
    std::map<std::string, std::string> plain;    ///< rows without a mark
    std::string raw;                             ///< "Raw Output", preformatted
};
/// The last line has the scores: a file without one is a released zero. The line before is the
/// feedback: a stage whose entries are all objects has marks, any other is a plain table.
[[nodiscard]] AutolabGrade readByAutolab(const std::string& output);

/// classroom-resources/autograding-grading-reporter v1 (d13b591) and main (43c2d9f).
struct ClassroomRun {
    std::optional<std::string> points;  ///< "0/1" in the roster; empty: nothing is sent
    bool isGreen = false;
    std::string log;  ///< messages of tests with errors only; printed raw
};
[[nodiscard]] ClassroomRun readByClassroom(const std::string& json);

/// PrairieLearn 88fb855 (pl-external-grader-results).
struct PrairieLearnPanel {
    std::string heading;                       ///< "1/1 (100%)", or "Invalid, not gradable"
    std::map<std::string, std::string> icons;  ///< of each test: "check", "times", "info"
};
[[nodiscard]] PrairieLearnPanel readByPrairieLearn(const std::string& json);

/// Gradescope, docs/specs.md af5dee4 of gradescope/autograder_samples.
struct GradescopePage {
    std::optional<double> score;       ///< that the student sees before grades are published
    std::vector<std::string> shown;    ///< names of tests that the student sees
    std::vector<std::string> ticked;   ///< those that are green
    std::vector<std::string> crossed;  ///< those that are red
};
[[nodiscard]] GradescopePage readByGradescope(const std::string& json);

/// JUnit as Artemis (TestResultXmlParser 03a0deaa: an error fails as a failure does, what is
/// skipped counts for neither), Jenkins (junit-10.xsd 8c515de: message is an attribute, the rest
/// text) and GitLab (shows the text of failure and skipped) read it.
struct JUnitCase {
    std::string outcome = "passed";  ///< "passed", "failure", "error", "skipped"
    std::string message;             ///< the attribute: Artemis, Jenkins
    std::string text;                ///< GitLab
};
[[nodiscard]] std::map<std::string, JUnitCase> readByJUnit(const std::string& xml);

/// What Jenkins' schema (junit-10.xsd 031e285 of the xunit plugin) does not allow of the elements
/// and attributes that we may write; empty: nothing.
[[nodiscard]] std::string faultByJUnitSchema(const std::string& xml);

}  // namespace ticker::tests

#endif
