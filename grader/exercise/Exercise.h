#ifndef TICKER_EXERCISE_EXERCISE_H
#define TICKER_EXERCISE_EXERCISE_H

#include <grader/result/SubmissionResult.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ticker {

/// An expression of the handout. Repairs may put it in place of a value of its type.
struct Formula {
    std::string type;  ///< of the value, with its namespace
    std::string of;    ///< type of the variable that `@` stands for in the text; may be empty
    std::string text;
};

/// A task as an exercise's file describes it.
struct TaskEntry {
    std::string id;        ///< tag in the handout and in the stub's marks
    std::string title;     ///< title for reports
    std::string file;      ///< name of the file that contains it
    std::string function;  ///< function that the file must define, as students write it
    /// Symbols that linkers report as missing if the function is not defined.
    std::vector<std::string> symbols;
    /// Expressions that repairs may put in place of a value; may be empty.
    std::vector<Formula> formulas = {};

    /// Name of the function without its class.
    [[nodiscard]] std::string functionName() const;
};

/// Tasks that belong together; solving one option is enough.
struct OptionEntry {
    std::string name;
    std::vector<std::string> tasks;
};

/// A scene that every submission with this file renders for the report.
struct SceneEntry {
    std::string name;  ///< of scenes/NAME.xml
    std::string file;  ///< the file whose tasks it shows
    int width = 0;     ///< of the render, pixels
    int height = 0;
    bool isRandom = false;    ///< two right renders differ by noise
    bool isHandedIn = false;  ///< the handout asks for a screenshot of it
};

/// An exercise as described in its exercise.json. docs/schema/exercise.schema.json documents the
/// names.
struct Exercise {
    std::string name;       ///< as --exercise and results have it
    std::string title;      ///< for people
    std::string handout;    ///< path in the project
    std::string stubs;      ///< "template": folder of the files as handed out
    std::string reference;  ///< folder of the same files, solved
    std::string rubric;     ///< file of what earns the tick, unless a course has its own
    std::string corpus;     ///< folder of samples/, mistakes/ and further collections
    std::vector<TaskEntry> tasks;
    std::vector<OptionEntry> options;
    std::vector<SceneEntry> scenes;
    /// Folder that is laid over the template for students, its framework over the kit's; may be
    /// empty.
    std::string overlay;
    /// Folder of framework/src that its students do not get; may be empty.
    std::string leftOut;
    /// Paths inside the kit of framework files that share their name with a file of the exercise.
    std::vector<std::string> frameworkFiles;

    /// The files that a submission may contain, in the order of their tasks.
    [[nodiscard]] std::vector<std::string> files() const;
    /// Whether a screenshot of some scene is handed in.
    [[nodiscard]] bool hasScreenshot() const;
    /// The files and the screenshot, if there is one: all parts of a submission.
    [[nodiscard]] std::vector<std::string> parts() const;
    /// Ids of the tasks and of the screenshot, if there is one: the contents of a result.
    [[nodiscard]] std::vector<std::string> reported() const;
    /// Null if no task has this id.
    [[nodiscard]] const TaskEntry* task(std::string_view id) const;
    /// The file that contains a task; empty for the screenshot.
    [[nodiscard]] std::string_view fileOf(std::string_view task) const;
    /// Expressions that repairs of a file may put in place of a value: the formulas of its tasks,
    /// except tasks whose function is in `leftAlone`.
    /// @param leftAlone  Names of functions, with commas and no blanks between them.
    [[nodiscard]] std::vector<Formula> formulasOf(std::string_view file,
                                                  std::string_view leftAlone) const;
    /// Whether an option has a task in a file.
    [[nodiscard]] bool isIn(std::string_view option, std::string_view file) const;
};

/// Id and file name of the screenshot's task, if the exercise has one (`hasScreenshot`).
inline constexpr std::string_view kScreenshotTask = "screenshot";
inline constexpr std::string_view kScreenshotPart = "screenshot.png";

/// @throws raytracer::InputError with the file, the line, the member and what was expected.
[[nodiscard]] Exercise readExercise(const std::filesystem::path& file);
/// readExercise for a text. @param file  Name in messages.
[[nodiscard]] Exercise parseExercise(const std::string& file, const std::string& text);

/// The exercises that this program was built with, the default one first. Their files are compiled
/// into the program.
[[nodiscard]] const std::vector<Exercise>& knownExercises();
[[nodiscard]] const Exercise& defaultExercise();
/// @throws raytracer::InputError with the known names if no exercise has this one.
[[nodiscard]] const Exercise& exerciseNamed(std::string_view name);

/// The exercise that a result names; the default one in results of older tools.
/// @throws raytracer::InputError as `exerciseNamed`.
[[nodiscard]] const Exercise& exerciseOf(const SubmissionResult& result);
/// The exercise of a class; the default one for an empty class.
/// @throws raytracer::InputError if the results are of more than one, or as `exerciseNamed`.
[[nodiscard]] const Exercise& exerciseOf(const std::vector<SubmissionResult>& results);

/// "a, b or c" for the word "or".
[[nodiscard]] std::string enumerated(const std::vector<std::string>& names, std::string_view word);

}  // namespace ticker

#endif
