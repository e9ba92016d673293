#ifndef TICKER_REPORT_STUDENTVIEW_H
#define TICKER_REPORT_STUDENTVIEW_H

#include <grader/exercise/Exercise.h>
#include <grader/result/SubmissionResult.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ticker::report {

/// What students are shown, as data; see student-view.schema.json.
struct StudentPolicy {
    bool hints = true;
    bool compilerOutput = true;
    bool warnings = true;
    bool notes = true;
    bool ownPictures = true;
    std::vector<std::string> evidence;  ///< keys; all others are withheld
};

/// Reads a policy file.
/// @throws raytracer::InputError naming the file, the member and what was expected.
[[nodiscard]] StudentPolicy readStudentPolicy(const std::filesystem::path& file);

/// A result without anything that a student must not see: no seed, no expected picture, no plot or
/// map of what was asked, no measured value but those that the policy names, no reason of ours.
/// Whatever students are shown is made from one of these.
class StudentView {
public:
    /// @param comment  What the person who decided says; empty: nobody said anything.
    /// @param proposed  The tool's own verdict; nothing: as in `result`.
    StudentView(SubmissionResult result, const StudentPolicy& policy, std::string comment = {},
                std::optional<Verdict> proposed = {}, const Exercise& exercise = theExercise());

    [[nodiscard]] const SubmissionResult& result() const { return result_; }
    [[nodiscard]] const std::string& comment() const { return comment_; }
    [[nodiscard]] Verdict proposed() const { return proposed_; }
    [[nodiscard]] const Exercise& exercise() const { return *exercise_; }

private:
    SubmissionResult result_;
    std::string comment_;
    Verdict proposed_;
    const Exercise* exercise_;
};

/// True where the student worked on this task, or something is to be said about it.
[[nodiscard]] bool concernsStudent(const TaskReport& task);

/// True where the task is right or wrong, and neither a person's business nor unchecked.
[[nodiscard]] bool isDecided(const TaskReport& task);

/// True where the verdict is one: a score that a platform may store and release.
[[nodiscard]] bool hasScore(const SubmissionResult& result);

/// Id and title, "Screenshot": stable and unique in a result.
[[nodiscard]] std::string taskName(const TaskReport& task);

/// The findings of one task with their hints, as plain text over several lines; not escaped for any
/// format but free of control characters. What was said of an earlier task is not said again. Never
/// empty.
[[nodiscard]] std::string shortText(const StudentView& view, const TaskReport& task);

/// The same, and what the compiler said.
[[nodiscard]] std::string taskText(const StudentView& view, const TaskReport& task);

/// The names of a task and of all later ones of which the same is said.
[[nodiscard]] std::string headingOf(const StudentView& view, const TaskReport& task);

/// One or two sentences on the verdict, and the person's comment, as plain text without control
/// characters.
[[nodiscard]] std::string verdictText(const StudentView& view);

/// verdictText, then the text of each task that concerns the student, under its name; what is the
/// same for several tasks once, under all names.
[[nodiscard]] std::string wholeText(const StudentView& view);

}  // namespace ticker::report

#endif
