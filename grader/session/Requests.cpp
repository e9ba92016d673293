#include <grader/session/Requests.h>

#include <grader/report/Escape.h>
#include <grader/result/Names.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace ticker::session {
namespace {

using json = nlohmann::json;

constexpr std::size_t kLongestComment = 20'000;
// The page allows names of 60 characters, which take up to three bytes each.
constexpr std::size_t kLongestName = 200;
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
    if (hasTexts(request, {"files"}))
        decision.files = report::escapeLine(request["files"].get<std::string>());
    for (LineNote& note : decision.notes)
        note.text = cleanText(note.text);
    if (decision.files.size() > kLongestName) return std::nullopt;
    return decision;
}

/// Why a decision is too large to be stored; empty if it is not.
std::string excessOf(const Decision& decision) {
    std::size_t length = decision.comment.size();
    for (const LineNote& note : decision.notes)
        length += note.text.size();
    if (length > kLongestComment)
        return fmt::format(
            "The comment and the comments on lines have {} bytes together, and {} are the most; "
            "shorten them.",
            length, kLongestComment);
    if (decision.notes.size() > kMostNotes)
        return fmt::format("{} lines have a comment, and {} are the most; remove some.",
                           decision.notes.size(), kMostNotes);
    if (decision.who.size() > kLongestName || decision.bulk.size() > kLongestName)
        return fmt::format("A name has more than {} bytes; shorten yours at the top of the page.",
                           kLongestName);
    return "";
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
            {"timesGraded", row.timesGraded},   {"proven", std::move(proven)}};
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

DecisionsRead readDecisions(const std::string& body) {
    const DecisionsRead malformed{{}, "This is no decision; load the page again."};
    const json request = json::parse(body, nullptr, false);
    if (!request.is_object() || !request.contains("decisions") || !request["decisions"].is_array())
        return malformed;
    DecisionsRead read;
    for (const json& one : request["decisions"]) {
        std::optional<Decision> decision = readDecision(one);
        if (!decision) return malformed;
        if (std::string excess = excessOf(*decision); !excess.empty()) return {{}, excess};
        read.decisions.push_back(std::move(*decision));
    }
    return read;
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
