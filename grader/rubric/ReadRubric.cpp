#include <grader/base/JsonLines.h>
#include <grader/base/WholeFile.h>
#include <grader/result/FindingWords.h>
#include <grader/result/Names.h>
#include <grader/rubric/Rubric.h>

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <string_view>
#include <utility>

namespace ticker::rubric {
namespace {

using nlohmann::json;
using raytracer::InputError;

struct File {
    std::string name;
    std::string text;
};

/// Reads members of one JSON object and says where it is in the file when one does not fit.
class Member {
public:
    Member(const File& file, std::string place, const json& value)
        : file_(file), place_(std::move(place)), value_(value) {}

    [[noreturn]] void refuse(const std::string& why) const {
        throw InputError(file_.name, jsonLineOf(file_.text, place_),
                         fmt::format("{}: {}", place_.empty() ? "the whole file" : place_, why));
    }
    [[noreturn]] void fail(const std::string& expected) const {
        refuse(fmt::format("expected {}, found {}", expected, value_.dump().substr(0, 60)));
    }

    void expectOnly(std::span<const std::string_view> names) const {
        if (!value_.is_object()) fail("an object");
        for (const auto& [name, value] : value_.items())
            if (std::ranges::find(names, name) == names.end())
                Member{file_, place_ + "/" + name, value}.refuse(
                    "expected no member of this name" + raytracer::knownNamesHint(name, names));
    }

    [[nodiscard]] Member at(const std::string& name) const {
        if (!value_.contains(name)) fail("a member \"" + name + "\"");
        return {file_, place_ + "/" + name, value_.at(name)};
    }

    [[nodiscard]] std::vector<Member> items() const {
        if (!value_.is_array() || value_.empty()) fail("an array that is not empty");
        std::vector<Member> members;
        for (std::size_t i = 0; i < value_.size(); ++i)
            members.push_back({file_, place_ + "/" + std::to_string(i), value_[i]});
        return members;
    }

    [[nodiscard]] std::string text() const {
        if (!value_.is_string()) fail("a string");
        return value_.get<std::string>();
    }

    [[nodiscard]] double number(double atLeast) const {
        if (!value_.is_number() || !(value_.get<double>() >= atLeast))
            fail(fmt::format("a number of at least {}", atLeast));
        return value_.get<double>();
    }

    [[nodiscard]] const json& value() const { return value_; }

private:
    const File& file_;
    std::string place_;
    const json& value_;
};

Option readOption(const Member& member) {
    static constexpr std::array<std::string_view, 3> kMembers{"name", "tasks", "points"};
    static constexpr std::array<std::string_view, 3> kTasks{"T1", "T2.1", "T2.2"};
    member.expectOnly(kMembers);
    Option option{
        .name = member.at("name").text(), .tasks = {}, .points = member.at("points").number(0.0)};
    for (const Member& task : member.at("tasks").items()) {
        option.tasks.push_back(task.text());
        if (std::ranges::find(kTasks, option.tasks.back()) == kTasks.end())
            task.fail("\"T1\", \"T2.1\" or \"T2.2\"");
    }
    return option;
}

/// Results name the option that was worked on, or one of two words that no option may have.
std::vector<Option> readOptions(const Member& member) {
    std::set<std::string> taken{"", "both", "none"};
    std::vector<Option> options;
    for (const Member& each : member.items()) {
        options.push_back(readOption(each));
        if (!taken.insert(options.back().name).second)
            each.at("name").fail("a name of its own, other than \"both\" and \"none\"");
    }
    return options;
}

std::string unknownFinding(std::string_view id, std::span<const std::string_view> known) {
    const auto nearest = raytracer::nearestName(id, known);
    return "expected a finding of docs/findings.md" +
           (nearest ? fmt::format("; did you mean \"{}\"?", *nearest) : "");
}

std::map<std::string, Severity> readSeverities(const Member& member) {
    if (!member.value().is_object()) member.fail("an object");
    std::vector<std::string_view> known;
    for (const auto& [id, unused] : kFindingWords)
        known.push_back(id);
    std::map<std::string, Severity> severities;
    for (const auto& [id, unused] : member.value().items()) {
        const Member entry = member.at(id);
        if (std::ranges::find(known, id) == known.end()) entry.refuse(unknownFinding(id, known));
        const auto severity = valueIn(kSeverityNames, entry.text());
        if (!severity) entry.fail("\"fail\", \"warn\" or \"note\"");
        severities[id] = *severity;
    }
    return severities;
}

json parse(const File& file) {
    try {
        return json::parse(file.text);
    } catch (const json::parse_error& error) {
        throw InputError(file.name, lineOfByte(file.text, error.byte),
                         fmt::format("not JSON: {}", error.what()));
    }
}

}  // namespace

Rubric readRubric(const std::filesystem::path& path) {
    const File file{path.string(), readWhole(path, "cannot be read; expected a rubric")};
    const json document = parse(file);
    static constexpr std::array<std::string_view, 4> kMembers{"maxScore", "options",
                                                              "screenshotTask", "severities"};
    const Member top{file, "", document};
    top.expectOnly(kMembers);
    Rubric rubric;
    rubric.maxScore = top.at("maxScore").number(1e-9);
    rubric.options = readOptions(top.at("options"));
    rubric.screenshotTask = top.at("screenshotTask").text();
    if (!rubric.screenshotTask.empty() && rubric.screenshotTask != "screenshot")
        top.at("screenshotTask").fail("\"screenshot\", or \"\" where no picture is asked for");
    rubric.severities = readSeverities(top.at("severities"));
    return rubric;
}

}  // namespace ticker::rubric
