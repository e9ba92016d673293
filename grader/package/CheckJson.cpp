#include <grader/package/CheckJson.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace ticker::package {
namespace {

using Json = nlohmann::ordered_json;

bool hasTask(const Json& option, const std::string& id) {
    const Json& tasks = option.at("tasks");
    return std::find(tasks.begin(), tasks.end(), id) != tasks.end();
}

std::string filesOf(const OptionEntry& option, const Exercise& exercise) {
    std::set<std::string> seen;
    std::string files;
    for (const std::string& id : option.tasks) {
        const std::string file{exercise.fileOf(id)};
        if (seen.insert(file).second) files += (files.empty() ? "exercise/" : ", exercise/") + file;
    }
    return files;
}

/// The option of `text` that has one of these tasks; a new one if none has.
Json& entryOf(const OptionEntry& option, Json& options, const Exercise& exercise) {
    const auto found = std::find_if(options.begin(), options.end(), [&](const Json& entry) {
        return std::ranges::any_of(option.tasks,
                                   [&](const std::string& id) { return hasTask(entry, id); });
    });
    if (found != options.end()) return *found;
    options.push_back(
        {{"name", option.name}, {"file", filesOf(option, exercise)}, {"tasks", Json::array()}});
    return options.back();
}

}  // namespace

std::string withEveryTask(const std::string& text, const Exercise& exercise) {
    Json description = Json::parse(text);
    bool lacksSome = false;
    for (const OptionEntry& option : exercise.options) {
        Json& entry = entryOf(option, description.at("options"), exercise);
        for (const std::string& id : option.tasks) {
            if (hasTask(entry, id)) continue;
            entry.at("tasks").push_back(id);
            lacksSome = true;
        }
    }
    return lacksSome ? description.dump(2) + "\n" : text;
}

}  // namespace ticker::package
