#ifndef TICKER_REPORT_STUDENT_STUDENTVIEW_H
#define TICKER_REPORT_STUDENT_STUDENTVIEW_H

#include <grader/exercise/Exercise.h>
#include <grader/result/Decision.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ticker::report {

/// What students may see, as data; see student-view.schema.json.
struct StudentPolicy {
    bool hints = true;
    bool compilerOutput = true;
    bool warnings = true;
    bool notes = true;
    bool ownPictures = true;
    bool rays = false;  ///< of one pixel or point that was asked about
    /// What students read of proven edits: nothing, or their line if all of a task are in one.
    enum class Repairs { off, line, lineAndHint } repairs = Repairs::off;
    std::vector<std::string> evidence;  ///< keys; all others are withheld
};

/// Reads a policy file.
/// @throws raytracer::InputError with the file, the member and what was expected.
[[nodiscard]] StudentPolicy readStudentPolicy(const std::filesystem::path& file);

/// A result without the data that students must not see: no seed, no expected picture, no plot or
/// map of the questions, no measured value except those in the policy, no internal reason. All
/// output for students is made from a StudentView.
class StudentView {
public:
    /// @param comment   The ticker's comment, Markdown; empty if there is no comment.
    /// @param proposed  The tool's own verdict; without a value: that of `result`.
    /// @param exercise  The result's exercise.
    /// @param notes     The ticker's comments on single lines.
    StudentView(SubmissionResult result, const StudentPolicy& policy, std::string comment,
                std::optional<Verdict> proposed, const Exercise& exercise,
                std::vector<LineNote> notes = {});
    /// The same for the exercise that the result names.
    StudentView(const SubmissionResult& result, const StudentPolicy& policy,
                std::string comment = {}, std::optional<Verdict> proposed = {},
                std::vector<LineNote> notes = {});

    [[nodiscard]] const SubmissionResult& result() const { return result_; }
    [[nodiscard]] const std::string& comment() const { return comment_; }
    [[nodiscard]] const std::vector<LineNote>& notes() const { return notes_; }
    /// Names the result to staff; see `appealNumber`.
    [[nodiscard]] const std::string& appealNumber() const { return appealNumber_; }
    [[nodiscard]] Verdict proposed() const { return proposed_; }
    [[nodiscard]] const Exercise& exercise() const { return *exercise_; }

private:
    SubmissionResult result_;
    std::string comment_;
    std::vector<LineNote> notes_;
    Verdict proposed_;
    std::string appealNumber_;
    const Exercise* exercise_;
};

/// True if the student attempted this task, or if it has findings.
[[nodiscard]] bool concernsStudent(const TaskReport& task);

/// True if the task's state is certain: it was graded and checked, and needs no review. A task that
/// is not attempted counts as certain.
[[nodiscard]] bool isCertain(const TaskReport& task);

/// True if the verdict gives a score that a platform may store and release.
[[nodiscard]] bool hasScore(const SubmissionResult& result);

/// Id and title, or "Screenshot": stable and unique in a result.
[[nodiscard]] std::string taskName(const TaskReport& task);

/// The findings of one task with their hints, as plain text of several lines. Not escaped for any
/// format, but without control characters. Texts of an earlier task are not repeated. Never empty.
[[nodiscard]] std::string shortText(const StudentView& view, const TaskReport& task);

/// shortText and the compiler's messages.
[[nodiscard]] std::string taskText(const StudentView& view, const TaskReport& task);

/// The names of a task and of all later ones with the same text.
[[nodiscard]] std::string headingOf(const StudentView& view, const TaskReport& task);

/// One or two sentences on the verdict.
[[nodiscard]] std::string verdictSentence(const StudentView& view);

/// verdictSentence, the ticker's comment and line notes, as plain text without control characters.
[[nodiscard]] std::string verdictText(const StudentView& view);

/// The text of each task that concerns the student, under its name. A text that several tasks share
/// appears once, under all names. Ends with a newline unless it is empty.
[[nodiscard]] std::string tasksText(const StudentView& view);

/// verdictText, then tasksText.
[[nodiscard]] std::string wholeText(const StudentView& view);

}  // namespace ticker::report

#endif
