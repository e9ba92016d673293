#include "ClientRules.h"

#include <tinyxml2.h>
#include <nlohmann/json.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

namespace ticker::tests {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

std::vector<std::string> linesOf(const std::string& text) {
    std::istringstream stream{text};
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

void readStage(const ordered_json& stage, AutolabGrade& grade) {
    const bool hasMarks =
        std::ranges::all_of(stage, [](const ordered_json& entry) { return entry.is_object(); });
    for (const auto& [name, entry] : stage.items()) {
        if (!hasMarks)
            grade.plain[name] = entry.get<std::string>();
        else if (entry.value("passed", false))
            grade.ticked.push_back(name);
        else
            grade.crossed[name] = entry.value("hint", "");
    }
}

// At most two decimals, without a zero at the end.
std::string rounded(double value) {
    std::string text = fmt::format("{:.2f}", value);
    while (text.ends_with('0'))
        text.pop_back();
    if (text.ends_with('.')) text.pop_back();
    return text;
}

std::string iconOf(const json& test) {
    if (rounded(test.at("max_points")) == "0") return "info";
    return rounded(test.at("points")) == rounded(test.at("max_points")) ? "check" : "times";
}

}  // namespace

AutolabGrade readByAutolab(const std::string& output) {
    AutolabGrade grade;
    grade.raw = output;
    const std::vector<std::string> lines = linesOf(output);
    const json scores =
        lines.empty() ? json{} : json::parse(lines.back(), nullptr, /*allow_exceptions=*/false);
    if (!scores.is_object() || !scores.contains("scores")) {
        grade.score = 0.0;
        grade.isReleased = true;
        return grade;
    }
    if (const json& tick = scores.at("scores").at("Tick"); !tick.is_null()) {
        grade.score = tick.get<double>();
        grade.isReleased = true;
    }
    const auto feedback = ordered_json::parse(lines.at(lines.size() - 2));
    if (feedback.at("_presentation") != "semantic")
        throw std::runtime_error("Autolab shows no semantic feedback");
    for (const auto& stage : feedback.at("stages"))
        readStage(feedback.at(stage.get<std::string>()), grade);
    return grade;
}

ClassroomRun readByClassroom(const std::string& text) {
    const json results = json::parse(text);
    ClassroomRun run;
    run.isGreen = results.at("status") == "pass";
    double points = 0.0;
    for (const json& test : results.at("tests")) {
        points += test.at("score").get<double>();
        if (test.at("status") == "error") run.log += test.at("message").get<std::string>() + "\n";
        run.log += test.at("test_code").get<std::string>();
    }
    if (const double most = results.at("max_score"); most != 0.0)
        run.points = fmt::format("{:g}/{:g}", points, most);
    return run;
}

PrairieLearnPanel readByPrairieLearn(const std::string& text) {
    const json results = json::parse(text);
    PrairieLearnPanel panel;
    double points = 0.0;
    double most = 0.0;
    if (results.contains("tests"))
        for (const json& test : results.at("tests")) {
            points += test.at("points").get<double>();
            most += test.at("max_points").get<double>();
            panel.icons[test.at("name")] = iconOf(test);
        }
    panel.heading = results.at("gradable") == false
                        ? "Invalid, not gradable"
                        : fmt::format("{}/{} ({}%)", rounded(points), rounded(most),
                                      rounded(100.0 * results.at("score").get<double>()));
    return panel;
}

GradescopePage readByGradescope(const std::string& text) {
    const json results = json::parse(text);
    GradescopePage page;
    bool isScoreShown = true;
    for (const json& test : results.at("tests")) {
        const std::string visibility = test.value("visibility", "visible");
        // A test that is never shown does not count for the score; one that is shown later hides
        // the score until then.
        if (visibility == "after_published" || visibility == "after_due_date") isScoreShown = false;
        if (visibility != "visible") continue;
        page.shown.push_back(test.at("name"));
        if (test.value("status", "") == "passed") page.ticked.push_back(test.at("name"));
        if (test.value("status", "") == "failed") page.crossed.push_back(test.at("name"));
    }
    if (isScoreShown) page.score = results.at("score").get<double>();
    return page;
}

std::map<std::string, JUnitCase> readByJUnit(const std::string& xml) {
    tinyxml2::XMLDocument document;
    if (document.Parse(xml.c_str(), xml.size()) != tinyxml2::XML_SUCCESS)
        throw std::runtime_error("not XML: " + xml);
    std::map<std::string, JUnitCase> cases;
    const auto* suite = document.FirstChildElement("testsuites")->FirstChildElement("testsuite");
    for (const auto* test = suite->FirstChildElement("testcase"); test != nullptr;
         test = test->NextSiblingElement("testcase")) {
        JUnitCase& known = cases[test->Attribute("name")];
        const auto* child = test->FirstChildElement();
        if (child == nullptr || std::string{child->Name()} == "system-out") continue;
        known.outcome = child->Name();
        known.message = child->Attribute("message");
        known.text = child->GetText() == nullptr ? "" : child->GetText();
    }
    return cases;
}

namespace {

struct JUnitElement {
    std::set<std::string> children;
    std::set<std::string> attributes;
    std::set<std::string> needed;
};

const std::map<std::string, JUnitElement>& junitElements() {
    static const std::map<std::string, JUnitElement> elements{
        {"testsuites", {{"testsuite"}, {"name", "time", "tests", "failures", "errors"}, {}}},
        {"testsuite",
         {{"testcase", "properties", "system-out", "system-err"},
          {"name", "tests", "failures", "errors", "group", "time", "skipped", "timestamp",
           "hostname", "id", "package", "file", "log", "url"},
          {"name", "tests", "failures", "errors"}}},
        {"testcase",
         {{"skipped", "error", "failure", "system-out", "system-err"},
          {"name", "time", "classname", "group"},
          {"name"}}},
        {"skipped", {{}, {"message", "type"}, {}}},
        {"failure", {{}, {"message", "type"}, {}}},
        {"error", {{}, {"message", "type"}, {}}},
        {"system-out", {{}, {}, {}}}};
    return elements;
}

std::string faultOf(const tinyxml2::XMLElement& element) {
    const std::string name = element.Name();
    const auto known = junitElements().find(name);
    if (known == junitElements().end()) return "element " + name;
    std::set<std::string> needed = known->second.needed;
    for (const auto* at = element.FirstAttribute(); at != nullptr; at = at->Next()) {
        if (!known->second.attributes.contains(at->Name())) return name + " " + at->Name();
        needed.erase(at->Name());
        const std::string value = at->Value();
        if (name == "testsuite" && at->Name() == std::string{"time"} &&
            value.find_first_not_of("0123456789,.") != std::string::npos)
            return "testsuite time is no number";
    }
    if (!needed.empty()) return name + " lacks " + *needed.begin();
    for (const auto* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
        if (!known->second.children.contains(child->Name()))
            return name + " holds " + child->Name();
        if (std::string fault = faultOf(*child); !fault.empty()) return fault;
    }
    return {};
}

}  // namespace

std::string faultByJUnitSchema(const std::string& xml) {
    tinyxml2::XMLDocument document;
    if (document.Parse(xml.c_str(), xml.size()) != tinyxml2::XML_SUCCESS) return "not XML";
    return faultOf(*document.RootElement());
}

}  // namespace ticker::tests
