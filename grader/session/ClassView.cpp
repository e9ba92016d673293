#include <grader/base/WholeFile.h>
#include <grader/session/ClassView.h>
#include <grader/session/SubmissionView.h>

#include <grader/report/Escape.h>
#include <grader/result/Names.h>
#include <grader/store/ClassFolder.h>

#include <nlohmann/json.hpp>

#include <map>
#include <system_error>
#include <utility>

namespace ticker::session {
namespace fs = std::filesystem;
namespace {

using json = nlohmann::json;

constexpr std::size_t kLongestComment = 20'000;
constexpr std::size_t kLongestName = 100;

json jsonOf(const Decision& decision) {
    return {{"version", decision.version}, {"ruling", nameIn(kRulingNames, decision.ruling)},
            {"comment", decision.comment}, {"who", decision.who},
            {"when", decision.when},       {"proposed", toString(decision.proposed)}};
}

json jsonOf(const store::ResultRow& row) {
    return {{"name", row.submission},
            {"shown", cleanText(row.submission)},
            {"verdict", toString(row.verdict)},
            {"option", row.option},
            {"findings", row.findings}};
}

std::string textOf(const json& value) {
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

Reply failure(int status, const std::string& message) {
    return {status, "application/json", textOf({{"error", message}})};
}

bool isRegular(const fs::path& file) {
    std::error_code error;
    return fs::is_regular_file(fs::symlink_status(file, error));
}

/// Reads a decision from a request; empty if it is not a decision.
std::optional<Decision> readDecision(const std::string& body) {
    const json request = json::parse(body, nullptr, false);
    if (!request.is_object()) return std::nullopt;
    for (const char* name : {"submission", "ruling", "comment", "who"})
        if (!request.contains(name) || !request[name].is_string()) return std::nullopt;
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
    if (decision.comment.size() > kLongestComment || decision.who.size() > kLongestName)
        return std::nullopt;
    return decision;
}

// The answer to a stored decision was lost, and the page sends it again.
bool isSentAgain(const Decision& sent, const Decision& current) {
    return current.version == sent.version + 1 && current.ruling == sent.ruling &&
           current.comment == sent.comment && current.who == sent.who;
}

}  // namespace

ClassView::ClassView(fs::path out) : out_(std::move(out)), store_(out_) {}

Reply ClassView::list() const {
    std::map<std::string, Decision> decisions;
    for (Decision& decision : store_.decisions())
        decisions[decision.submission] = std::move(decision);
    json all = json::array();
    for (const store::ResultRow& row : store_.results()) {
        json entry = jsonOf(row);
        if (const auto found = decisions.find(row.submission); found != decisions.end())
            entry["decision"] = jsonOf(found->second);
        all.push_back(std::move(entry));
    }
    return {200, "application/json", textOf({{"submissions", std::move(all)}})};
}

Reply ClassView::submission(const std::string& name) const {
    if (!store_.find(name)) return failure(404, "there is no such submission");
    const auto result = store::readWholeResult(out_, name);
    if (!result) return failure(503, "it is being graded at this moment");
    json history = json::array();
    for (const Decision& decision : store_.history(name))
        history.push_back(jsonOf(decision));
    return {200, "application/json",
            textOf({{"html", submissionHtml(*result, out_ / name / "code")},
                    {"history", std::move(history)}})};
}

Reply ClassView::image(const std::string& name, const std::string& file) const {
    const bool isPlain =
        file.ends_with(".png") && !file.starts_with('.') && file.find('/') == std::string::npos;
    const fs::path path = out_ / name / "images" / file;
    if (!isPlain || !store_.find(name) || !isRegular(path))
        return failure(404, "there is no such picture");
    return {200, "image/png", readIfThere(path).value_or("")};
}

Reply ClassView::reportPage(const std::string& name) const {
    const fs::path path = out_ / name / "report.html";
    if (!store_.find(name) || !isRegular(path)) return failure(404, "there is no such report");
    return {200, "text/html; charset=utf-8", readIfThere(path).value_or("")};
}

Reply ClassView::decide(const std::string& body) {
    std::optional<Decision> decision = readDecision(body);
    if (!decision) return failure(400, "this is no decision");
    const std::optional<store::ResultRow> row = store_.find(decision->submission);
    if (!row) return failure(404, "there is no such submission");
    decision->proposed = row->verdict;
    decision->when = store::utcNow();
    const store::DecideOutcome outcome = store_.decide(*decision);
    const bool isKept = outcome.isKept || isSentAgain(*decision, outcome.current);
    return {isKept ? 200 : 409, "application/json", textOf(jsonOf(outcome.current))};
}

}  // namespace ticker::session
