#include <grader/result/Names.h>
#include <grader/rubric/JsonMember.h>
#include <grader/rubric/Rubric.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace ticker::rubric {
namespace {

Option readOption(const JsonMember& member) {
    member.expectOnly({"name", "tasks", "points"});
    Option option{
        .name = member.at("name").text(), .tasks = {}, .points = member.at("points").number(0.0)};
    static constexpr std::array kTasks{"T1", "T2.1", "T2.2"};
    for (const JsonMember& task : member.at("tasks").items()) {
        option.tasks.push_back(task.text());
        if (std::find(kTasks.begin(), kTasks.end(), option.tasks.back()) == kTasks.end())
            task.fail("\"T1\", \"T2.1\" or \"T2.2\"");
    }
    return option;
}

std::map<std::string, Severity> readSeverities(const JsonMember& member) {
    if (!member.value().is_object()) member.fail("an object");
    std::map<std::string, Severity> severities;
    for (const auto& [id, unused] : member.value().items()) {
        const JsonMember entry = member.at(id);
        const auto severity = valueIn(kSeverityNames, entry.text());
        if (!severity) entry.fail("\"fail\", \"warn\" or \"note\"");
        severities[id] = *severity;
    }
    return severities;
}

}  // namespace

Rubric readRubric(const std::filesystem::path& file) {
    const nlohmann::json document = readJson(file, "a rubric");
    const JsonMember top{file.string(), "", document};
    top.expectOnly({"maxScore", "options", "screenshotTask", "severities"});
    Rubric rubric;
    rubric.maxScore = top.at("maxScore").number(1e-9);
    for (const JsonMember& option : top.at("options").items())
        rubric.options.push_back(readOption(option));
    rubric.screenshotTask = top.at("screenshotTask").text();
    rubric.severities = readSeverities(top.at("severities"));
    return rubric;
}

}  // namespace ticker::rubric
