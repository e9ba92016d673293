#ifndef TICKER_EXERCISE_EXERCISE_H
#define TICKER_EXERCISE_EXERCISE_H

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ticker {

/// A task as an exercise's file describes it.
struct TaskEntry {
    std::string id;                    ///< the tag in the handout and in the stub's marks
    std::string title;                 ///< for people
    std::string file;                  ///< the one that it is solved in, by its name
    std::string function;              ///< that the file must define, as students write it
    std::vector<std::string> symbols;  ///< what linkers say is missing where it does not
};

/// Tasks that belong together: one option is enough.
struct OptionEntry {
    std::string name;
    std::vector<std::string> tasks;
};

/// A scene that every submission with this file renders for people to look at.
struct SceneEntry {
    std::string name;  ///< of scenes/NAME.xml
    std::string file;  ///< whose tasks it shows
    int width = 0;     ///< of the render, pixels
    int height = 0;
    bool isRandom = false;    ///< two right renders differ by noise
    bool isHandedIn = false;  ///< a screenshot of it is what the handout asks for
};

/// An exercise, as its exercise.json describes it. Names are those of
/// docs/schema/exercise.schema.json.
struct Exercise {
    std::string name;
    std::string handout;    ///< path in the project
    std::string stubs;      ///< "template": folder of the files as they are handed out
    std::string reference;  ///< folder of the same files, solved
    std::vector<TaskEntry> tasks;
    std::vector<OptionEntry> options;
    std::vector<SceneEntry> scenes;
    /// Paths inside the kit of files that only share their name with one to hand in.
    std::vector<std::string> frameworkFiles;

    /// The files that a submission may bring, in the order of their tasks.
    [[nodiscard]] std::vector<std::string> files() const;
    /// The same and the screenshot: all that a submission consists of.
    [[nodiscard]] std::vector<std::string> parts() const;
    /// The tasks' ids and the screenshot's: what a result reports on.
    [[nodiscard]] std::vector<std::string> reported() const;
    /// Null if no task has this id.
    [[nodiscard]] const TaskEntry* task(std::string_view id) const;
    /// The file that a task is solved in; empty for the screenshot.
    [[nodiscard]] std::string_view fileOf(std::string_view task) const;
    /// Whether an option has a task in a file.
    [[nodiscard]] bool isIn(std::string_view option, std::string_view file) const;
};

/// The task of the picture, which every exercise has, and its file.
inline constexpr std::string_view kScreenshotTask = "screenshot";
inline constexpr std::string_view kScreenshotPart = "screenshot.png";

/// @throws raytracer::InputError naming the file, the line, the member and what was expected.
[[nodiscard]] Exercise readExercise(const std::filesystem::path& file);
/// The same for a text. @param file  For messages.
[[nodiscard]] Exercise parseExercise(const std::string& file, const std::string& text);

/// The exercise that this program was built for; it carries the file, wherever it lies.
[[nodiscard]] const Exercise& theExercise();

/// "a, b or c" where `word` is "or".
[[nodiscard]] std::string enumerated(const std::vector<std::string>& names, std::string_view word);

}  // namespace ticker

#endif
