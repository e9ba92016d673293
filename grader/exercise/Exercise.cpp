#include <grader/exercise/Exercise.h>

#include <algorithm>

namespace ticker {

extern const char* const kExerciseText;

std::vector<std::string> Exercise::files() const {
    std::vector<std::string> files;
    for (const TaskEntry& task : tasks)
        if (std::ranges::find(files, task.file) == files.end()) files.push_back(task.file);
    return files;
}

std::vector<std::string> Exercise::parts() const {
    std::vector<std::string> parts = files();
    parts.emplace_back(kScreenshotPart);
    return parts;
}

std::vector<std::string> Exercise::reported() const {
    std::vector<std::string> ids;
    for (const TaskEntry& task : tasks)
        ids.push_back(task.id);
    ids.emplace_back(kScreenshotTask);
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

bool Exercise::isIn(std::string_view option, std::string_view file) const {
    const auto found = std::ranges::find(options, option, &OptionEntry::name);
    return found != options.end() && std::ranges::any_of(found->tasks, [&](const std::string& id) {
               return fileOf(id) == file;
           });
}

const Exercise& theExercise() {
    static const Exercise kExercise = parseExercise("exercise.json", kExerciseText);
    return kExercise;
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
