#include <grader/exercise/Exercise.h>
#include <grader/exercise/ExerciseText.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <algorithm>

namespace ticker {

std::string TaskEntry::functionName() const {
    const std::size_t colons = function.rfind("::");
    return colons == std::string::npos ? function : function.substr(colons + 2);
}

std::vector<std::string> Exercise::files() const {
    std::vector<std::string> files;
    for (const TaskEntry& task : tasks)
        if (std::ranges::find(files, task.file) == files.end()) files.push_back(task.file);
    return files;
}

bool Exercise::hasScreenshot() const {
    return std::ranges::any_of(scenes, &SceneEntry::isHandedIn);
}

std::vector<std::string> Exercise::parts() const {
    std::vector<std::string> parts = files();
    if (hasScreenshot()) parts.emplace_back(kScreenshotPart);
    return parts;
}

std::vector<std::string> Exercise::reported() const {
    std::vector<std::string> ids;
    for (const TaskEntry& task : tasks)
        ids.push_back(task.id);
    if (hasScreenshot()) ids.emplace_back(kScreenshotTask);
    return ids;
}

const TaskEntry* Exercise::task(std::string_view id) const {
    const auto found = std::ranges::find(tasks, id, &TaskEntry::id);
    return found == tasks.end() ? nullptr : &*found;
}

std::string_view Exercise::fileOf(std::string_view id) const {
    const TaskEntry* entry = task(id);
    return entry == nullptr ? std::string_view{} : entry->file;
}

std::vector<Formula> Exercise::formulasOf(std::string_view file, std::string_view leftAlone) const {
    std::vector<Formula> all;
    const std::string names = "," + std::string{leftAlone} + ",";
    for (const TaskEntry& task : tasks)
        if (task.file == file && names.find("," + task.functionName() + ",") == std::string::npos)
            all.insert(all.end(), task.formulas.begin(), task.formulas.end());
    return all;
}

bool Exercise::isIn(std::string_view option, std::string_view file) const {
    const auto found = std::ranges::find(options, option, &OptionEntry::name);
    return found != options.end() && std::ranges::any_of(found->tasks, [&](const std::string& id) {
               return fileOf(id) == file;
           });
}

const std::vector<Exercise>& knownExercises() {
    static const std::vector<Exercise> kExercises = [] {
        std::vector<Exercise> exercises;
        for (const char* const* text = &kExerciseTexts[0]; *text != nullptr; ++text)
            exercises.push_back(parseExercise("exercise.json", *text));
        return exercises;
    }();
    return kExercises;
}

const Exercise& defaultExercise() {
    return knownExercises().front();
}

const Exercise& exerciseNamed(std::string_view name) {
    std::vector<std::string> names;
    for (const Exercise& exercise : knownExercises()) {
        if (exercise.name == name) return exercise;
        names.push_back(exercise.name);
    }
    throw raytracer::InputError(
        "", 0,
        fmt::format("there is no exercise \"{}\"; expected {}", name, enumerated(names, "or")));
}

const Exercise& exerciseOf(const SubmissionResult& result) {
    return result.exercise.empty() ? defaultExercise() : exerciseNamed(result.exercise);
}

const Exercise& exerciseOf(const std::vector<SubmissionResult>& results) {
    if (results.empty()) return defaultExercise();
    const Exercise& exercise = exerciseOf(results.front());
    for (const SubmissionResult& result : results)
        if (const Exercise& other = exerciseOf(result); &other != &exercise)
            throw raytracer::InputError(
                "", 0,
                fmt::format("\"{}\" is a result of {}, \"{}\" of {}: one class has one exercise",
                            results.front().submission, exercise.name, result.submission,
                            other.name));
    return exercise;
}

std::string enumerated(const std::vector<std::string>& names, std::string_view word) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " " + std::string{word} + " " : ", ";
        text += names[i];
    }
    return text;
}

}  // namespace ticker
