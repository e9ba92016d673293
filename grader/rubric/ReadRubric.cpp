#include <grader/result/Names.h>
#include <grader/rubric/Rubric.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <fstream>
#include <initializer_list>

namespace ticker::rubric {
namespace {

using nlohmann::json;
using raytracer::InputError;

/// Reads members of one JSON object and says where it is in the file when one does not fit.
class Member {
public:
    Member(std::string file, std::string place, const json& value)
        : file_(std::move(file)), place_(std::move(place)), value_(value) {}

    [[noreturn]] void fail(const std::string& expected) const {
        throw InputError(
            file_, 0,
            fmt::format("{}: expected {}, found {}", place_.empty() ? "the whole file" : place_,
                        expected, value_.dump().substr(0, 60)));
    }

    void expectOnly(std::initializer_list<const char*> names) const {
        if (!value_.is_object()) fail("an object");
        for (const auto& [name, unused] : value_.items())
            if (std::find(names.begin(), names.end(), name) == names.end())
                Member{file_, place_ + "/" + name, value_}.fail("no member of this name");
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
    std::string file_;
    std::string place_;
    const json& value_;
};

Option readOption(const Member& member) {
    member.expectOnly({"name", "tasks", "points"});
    Option option{
        .name = member.at("name").text(), .tasks = {}, .points = member.at("points").number(0.0)};
    static constexpr std::array kTasks{"T1", "T2.1", "T2.2"};
    for (const Member& task : member.at("tasks").items()) {
        option.tasks.push_back(task.text());
        if (std::find(kTasks.begin(), kTasks.end(), option.tasks.back()) == kTasks.end())
            task.fail("\"T1\", \"T2.1\" or \"T2.2\"");
    }
    return option;
}

std::map<std::string, Severity> readSeverities(const Member& member) {
    if (!member.value().is_object()) member.fail("an object");
    std::map<std::string, Severity> severities;
    for (const auto& [id, unused] : member.value().items()) {
        const Member entry = member.at(id);
        const auto severity = valueIn(kSeverityNames, entry.text());
        if (!severity) entry.fail("\"fail\", \"warn\" or \"note\"");
        severities[id] = *severity;
    }
    return severities;
}

}  // namespace

Rubric readRubric(const std::filesystem::path& file) {
    std::ifstream stream{file};
    if (!stream) throw InputError(file.string(), 0, "cannot be read; expected a rubric");
    json document;
    try {
        document = json::parse(stream);
    } catch (const json::exception& error) {
        throw InputError(file.string(), 0, fmt::format("not JSON: {}", error.what()));
    }
    const Member top{file.string(), "", document};
    top.expectOnly({"maxScore", "options", "screenshotTask", "severities"});
    Rubric rubric;
    rubric.maxScore = top.at("maxScore").number(1e-9);
    for (const Member& option : top.at("options").items())
        rubric.options.push_back(readOption(option));
    rubric.screenshotTask = top.at("screenshotTask").text();
    rubric.severities = readSeverities(top.at("severities"));
    return rubric;
}

}  // namespace ticker::rubric
