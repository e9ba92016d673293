#include <grader/session/Requests.h>

#include <grader/report/Escape.h>
#include <grader/result/Names.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace ticker::session {
namespace {

using json = nlohmann::json;

constexpr std::size_t kLongestComment = 20'000;
constexpr std::size_t kLongestName = 100;
constexpr std::size_t kMostNotes = 100;

bool hasTexts(const json& request, std::initializer_list<const char*> members) {
    return request.is_object() && std::ranges::all_of(members, [&](const char* name) {
               return request.contains(name) && request[name].is_string();
           });
}

std::optional<Decision> readDecision(const json& request) {
    if (!hasTexts(request, {"submission", "ruling", "comment", "who"})) return std::nullopt;
    if (!request.contains("version") || !request["version"].is_number_integer())
        return std::nullopt;
    const auto ruling = valueIn(kRulingNames, request["ruling"].get<std::string>());
    if (!ruling) return std::nullopt;
    Decision decision;
    decision.submission = request["submission"];
    decision.version = request["version"];
    decision.ruling = *ruling;
    decision.comment = cleanText(request["comment"].get<std::string>());
    decision.who = report::escapeLine(request["who"].get<std::string>());
    if (request.contains("notes")) decision.notes = readNotes(textOf(request["notes"]));
    if (hasTexts(request, {"bulk"}))
        decision.bulk = report::escapeLine(request["bulk"].get<std::string>());
    std::size_t length = decision.comment.size();
    for (LineNote& note : decision.notes) {
        note.text = cleanText(note.text);
        length += note.text.size();
    }
    const bool isSmall = length <= kLongestComment && decision.who.size() <= kLongestName &&
                         decision.bulk.size() <= kLongestName &&
                         decision.notes.size() <= kMostNotes;
    return isSmall ? std::optional{std::move(decision)} : std::nullopt;
}

}  // namespace

json jsonOf(const Decision& decision) {
    return {{"version", decision.version},
            {"ruling", nameIn(kRulingNames, decision.ruling)},
            {"comment", decision.comment},
            {"who", decision.who},
            {"when", decision.when},
            {"proposed", toString(decision.proposed)},
            {"notes", json::parse(notesText(decision.notes))},
            {"bulk", decision.bulk},
            {"files", decision.files}};
}

json jsonOf(const ProvenLine& line) {
    return {{"file", cleanText(line.file)},
            {"line", line.line},
            {"from", cleanText(line.from)},
            {"to", cleanText(line.to)}};
}

json jsonOf(const store::ResultRow& row) {
    json proven = json::array();
    for (const ProvenLine& line : row.proven)
        proven.push_back(jsonOf(line));
    return {{"name", row.submission},           {"shown", cleanText(row.submission)},
            {"verdict", toString(row.verdict)}, {"option", row.option},
            {"findings", row.findings},         {"tasks", row.tasks},
            {"files", row.inputs.files},        {"gradedAt", row.gradedAt},
            {"proven", std::move(proven)}};
}

json jsonOf(const store::SavedComment& comment) {
    return {{"id", comment.id},
            {"finding", comment.finding},
            {"text", comment.text},
            {"who", comment.who}};
}

std::string textOf(const json& value) {
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::optional<std::vector<Decision>> readDecisions(const std::string& body) {
    const json request = json::parse(body, nullptr, false);
    if (!request.is_object() || !request.contains("decisions") || !request["decisions"].is_array())
        return std::nullopt;
    std::vector<Decision> decisions;
    for (const json& one : request["decisions"]) {
        std::optional<Decision> decision = readDecision(one);
        if (!decision) return std::nullopt;
        decisions.push_back(std::move(*decision));
    }
    return decisions;
}

std::optional<store::SavedComment> readSavedComment(const std::string& body) {
    const json request = json::parse(body, nullptr, false);
    if (!hasTexts(request, {"finding", "text", "who"})) return std::nullopt;
    store::SavedComment comment;
    comment.finding = report::escapeLine(request["finding"].get<std::string>());
    comment.text = cleanText(request["text"].get<std::string>());
    comment.who = report::escapeLine(request["who"].get<std::string>());
    const bool isSmall = !comment.text.empty() && comment.text.size() <= kLongestComment &&
                         comment.who.size() <= kLongestName &&
                         comment.finding.size() <= kLongestName;
    return isSmall ? std::optional{std::move(comment)} : std::nullopt;
}

std::optional<std::string> readText(const std::string& body, const char* member) {
    const json request = json::parse(body, nullptr, false);
    if (!hasTexts(request, {member})) return std::nullopt;
    std::string text = request[member].get<std::string>();
    if (text.size() > kLongestComment) return std::nullopt;
    return text;
}

}  // namespace ticker::session
