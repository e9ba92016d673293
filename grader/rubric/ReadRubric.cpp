#include <grader/base/JsonValue.h>
#include <grader/base/WholeFile.h>
#include <grader/result/Names.h>
#include <grader/rubric/Rubric.h>
#include <grader/tasks/FindingTables.h>

#include <raytracer/base/Text.h>

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>

namespace ticker::rubric {
namespace {

constexpr JsonWords kWords{"the whole file", "a member", true};

std::vector<JsonValue> itemsOf(const JsonValue& value) {
    if (!value.isArray() || value.items().empty()) value.expect("an array that is not empty");
    return value.items();
}

double numberOf(const JsonValue& value, double atLeast) {
    const auto number = value.asNumber();
    if (!number || !(*number >= atLeast))
        value.expect(fmt::format("a number of at least {}", atLeast));
    return *number;
}

/// "\"a\", \"b\" or \"c\"": the tasks of the exercise.
std::string knownTasks(const Exercise& exercise) {
    std::vector<std::string> ids;
    for (const TaskEntry& task : exercise.tasks)
        ids.push_back('"' + task.id + '"');
    return enumerated(ids, "or");
}

Option readOption(const JsonValue& member, const Exercise& exercise) {
    member.allowOnly({"name", "tasks", "points"});
    Option option{.name = member.at("name").text(),
                  .tasks = {},
                  .points = numberOf(member.at("points"), 0.0)};
    for (const JsonValue& task : itemsOf(member.at("tasks"))) {
        option.tasks.push_back(task.text());
        if (exercise.task(option.tasks.back()) == nullptr) task.expect(knownTasks(exercise));
    }
    return option;
}

/// Results name the attempted option, or use one of two reserved words that no option may have.
std::vector<Option> readOptions(const JsonValue& member, const Exercise& exercise) {
    std::set<std::string> taken{"", std::string{kSeveralOptions}, "none"};
    std::vector<Option> options;
    for (const JsonValue& each : itemsOf(member)) {
        options.push_back(readOption(each, exercise));
        if (!taken.insert(options.back().name).second)
            each.at("name").expect("a name of its own, other than \"both\" and \"none\"");
    }
    return options;
}

std::string unknownFinding(std::string_view id, std::span<const std::string_view> known) {
    const auto nearest = raytracer::nearestName(id, known);
    return "expected a finding of docs/findings.md" +
           (nearest ? fmt::format("; did you mean \"{}\"?", *nearest) : "");
}

std::map<std::string, Severity> readSeverities(const JsonValue& member) {
    const auto members = member.members();
    std::vector<std::string_view> known;
    for (const FindingText* text : tasks::allFindings())
        known.push_back(text->id);
    std::map<std::string, Severity> severities;
    for (const auto& [id, entry] : std::map(members.begin(), members.end())) {
        if (std::ranges::find(known, id) == known.end()) entry.refuse(unknownFinding(id, known));
        const auto severity = valueIn(kSeverityNames, entry.text());
        if (!severity) entry.expect("\"fail\", \"warn\" or \"note\"");
        severities[id] = *severity;
    }
    return severities;
}

}  // namespace

Rubric readRubric(const std::filesystem::path& path, const Exercise& exercise) {
    const JsonValue top = JsonValue::parse(readWhole(path, "cannot be read; expected a rubric"),
                                           path.string(), kWords);
    top.allowOnly({"maxScore", "options", "screenshotTask", "severities"});
    Rubric rubric;
    rubric.maxScore = numberOf(top.at("maxScore"), 1e-9);
    rubric.options = readOptions(top.at("options"), exercise);
    rubric.screenshotTask = top.at("screenshotTask").text();
    if (!rubric.screenshotTask.empty() && rubric.screenshotTask != "screenshot")
        top.at("screenshotTask").expect("\"screenshot\", or \"\" where no picture is asked for");
    rubric.severities = readSeverities(top.at("severities"));
    return rubric;
}

}  // namespace ticker::rubric
