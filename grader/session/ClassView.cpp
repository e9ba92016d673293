#include <grader/base/Digest.h>
#include <grader/base/WholeFile.h>
#include <grader/session/ClassView.h>
#include <grader/session/Requests.h>
#include <grader/session/SubmissionView.h>

#include <grader/report/Escape.h>
#include <grader/report/Markdown.h>
#include <grader/report/PageParts.h>
#include <grader/report/SourceLines.h>
#include <grader/result/ResultJson.h>
#include <grader/store/ClassFolder.h>

#include <raytracer/base/Error.h>

#include <nlohmann/json.hpp>

#include <map>
#include <system_error>
#include <utility>

namespace ticker::session {
namespace fs = std::filesystem;
namespace {

using json = nlohmann::json;

Reply failure(int status, const std::string& message) {
    return {status, "application/json", textOf({{"error", message}})};
}

bool isRegular(const fs::path& file) {
    std::error_code error;
    return fs::is_regular_file(fs::symlink_status(file, error));
}

bool isRemoved(const fs::path& folder) {
    std::error_code error;
    return fs::status(folder, error).type() == fs::file_type::not_found;
}

/// Why a submission of the store cannot be shown. 503: it may be there in a moment.
Reply withoutResult(const fs::path& out, const std::string& name) {
    if (isRemoved(out / name))
        return failure(404, "Its folder is no longer there. Go on with the next one.");
    const std::string advice =
        "\"ticker grade\" with --resume grades it again; open it once more after that.";
    const std::optional<std::string> text = readIfThere(store::resultFile(out, name));
    if (!text)
        return failure(503,
                       "It has no result.json: it is being graded at this moment, or its grading "
                       "was interrupted. " +
                           advice);
    try {
        const std::string said = parseResultJson(*text, "result.json").submission;
        if (said == cleanText(name)) return failure(503, "It was being graded. Open it once more.");
        return failure(404, "Its result.json is that of \"" + said + "\". " + advice);
    } catch (const raytracer::InputError& problem) {
        return failure(404, std::string{"It is damaged: "} + problem.what() + ". " + advice);
    }
}

/// Adds to each note the text of its line. Removes notes on lines that never existed. A line that
/// is gone, since other files were handed in, keeps the text that was stored with its note.
void quoteLines(Decision& decision, const fs::path& code) {
    std::erase_if(decision.notes, [&](LineNote& note) {
        if (note.file.find('/') != std::string::npos || note.file.starts_with('.')) return true;
        if (!note.code.empty()) return false;
        const std::string source =
            isRegular(code / note.file) ? readIfThere(code / note.file).value_or("") : "";
        const auto lines = report::linesOf(source);
        const auto at = static_cast<std::size_t>(note.line - 1);
        if (at < lines.size()) note.code = cleanText(lines[at]);
        return at >= lines.size();
    });
}

// True if this decision is stored already: its answer was lost, and the page sent it again.
bool isSentAgain(const Decision& sent, const Decision& current) {
    return current.version == sent.version + 1 && current.ruling == sent.ruling &&
           current.comment == sent.comment && current.who == sent.who &&
           current.notes == sent.notes && current.bulk == sent.bulk;
}

/// The pairs of OUT/similar.json, which ticker similar writes: [{"name", "percent"}] by submission.
json similarOnes(const fs::path& out) {
    json similar = json::object();
    const json pairs = json::parse(readIfThere(out / "similar.json").value_or(""), nullptr, false);
    if (!pairs.is_array()) return similar;
    const auto isText = [](const json& pair, const char* member) {
        return pair.contains(member) && pair[member].is_string();
    };
    for (const json& pair : pairs) {
        if (!pair.is_object() || !isText(pair, "left") || !isText(pair, "right")) continue;
        const json percent = pair.value("percent", json(0));
        for (const auto& [one, other] : {std::pair{"left", "right"}, std::pair{"right", "left"}})
            similar[pair[one].get<std::string>()].push_back(
                {{"name", pair[other]}, {"percent", percent}});
    }
    return similar;
}

}  // namespace

ClassView::ClassView(fs::path out) : out_(std::move(out)), store_(out_) {}

std::vector<store::ResultRow> ClassView::rows() const {
    std::vector<store::ResultRow> rows = store_.results();
    std::erase_if(rows,
                  [&](const store::ResultRow& row) { return isRemoved(out_ / row.submission); });
    return rows;
}

Reply ClassView::list(const std::string& known) const {
    std::map<std::string, Decision> decisions;
    for (Decision& decision : store_.decisions())
        decisions[decision.submission] = std::move(decision);
    json all = json::array();
    const json similar = similarOnes(out_);
    for (const store::ResultRow& row : rows()) {
        json entry = jsonOf(row);
        entry["similar"] = similar.value(row.submission, json::array());
        if (const auto found = decisions.find(row.submission); found != decisions.end())
            entry["decision"] = jsonOf(found->second);
        all.push_back(std::move(entry));
    }
    json comments = json::array();
    for (const store::SavedComment& comment : store_.savedComments())
        comments.push_back(jsonOf(comment));
    json reply{{"submissions", std::move(all)}, {"comments", std::move(comments)}};
    const std::string state = Digest{}.add(textOf(reply)).text();
    if (state == known) reply = json::object();
    reply["state"] = state;
    return {200, "application/json", textOf(reply)};
}

Reply ClassView::submission(const std::string& name) const {
    if (!store_.find(name)) return failure(404, "there is no such submission");
    const auto result = store::readWholeResult(out_, name);
    if (!result) return withoutResult(out_, name);
    json history = json::array();
    for (const Decision& decision : store_.history(name))
        history.push_back(jsonOf(decision));
    try {
        return {200, "application/json",
                textOf({{"html", submissionHtml(*result, out_ / name / "code",
                                                store::earlierResults(out_, name))},
                        {"files", result->inputs.files},
                        {"history", std::move(history)}})};
    } catch (const raytracer::InputError& problem) {
        // Without an answer the page would ask for ever.
        return failure(404, std::string{"It cannot be shown: "} + problem.what() + ".");
    }
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

Reply ClassView::similarPage() const {
    if (!isRegular(out_ / "similar.html"))
        return failure(404, "nothing was compared yet: ticker similar OUT");
    return {200, "text/html; charset=utf-8", readIfThere(out_ / "similar.html").value_or("")};
}

Reply ClassView::pictures(const std::string& name) const {
    if (!store_.find(name)) return failure(404, "there is no such submission");
    const auto result = store::readWholeResult(out_, name);
    if (!result) return withoutResult(out_, name);
    json renders = json::array();
    for (const RenderScore& render : result->renders)
        if (!render.image.empty())
            renders.push_back(
                {{"scene", render.scene},
                 {"image", report::address("of/" + name + "/" + render.image)},
                 {"reference", render.reference.empty()
                                   ? ""
                                   : report::address("of/" + name + "/" + render.reference)}});
    return {200, "application/json",
            textOf({{"renders", std::move(renders)}, {"told", toldHtml(*result)}})};
}

Reply ClassView::decide(const std::string& body) {
    auto [decisions, refusal] = readDecisions(body);
    if (!refusal.empty()) return failure(400, refusal);
    for (Decision& decision : decisions) {
        const std::optional<store::ResultRow> row = store_.find(decision.submission);
        if (!row) return failure(404, "There is no such submission.");
        decision.proposed = row->verdict;
        if (decision.files.empty()) decision.files = row->inputs.files;
        decision.when = store::utcNow();
        quoteLines(decision, out_ / decision.submission / "code");
    }
    const std::vector<store::DecideOutcome> outcomes = store_.decide(decisions);
    ++changes_;
    json answers = json::array();
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        const store::DecideOutcome& outcome = outcomes[i];
        const bool isKept = outcome.isKept || isSentAgain(decisions[i], outcome.current);
        answers.push_back({{"isKept", isKept}, {"decision", jsonOf(outcome.current)}});
    }
    return {200, "application/json", textOf({{"answers", std::move(answers)}})};
}

Reply ClassView::saveComment(const std::string& body) {
    std::optional<store::SavedComment> comment = readSavedComment(body);
    if (!comment) return failure(400, "this is no comment");
    comment->when = store::utcNow();
    store_.saveComment(*comment);
    return {200, "application/json", "{}"};
}

Reply ClassView::dropComment(const std::string& body) {
    const json request = json::parse(body, nullptr, false);
    if (!request.is_object() || !request.contains("id") || !request["id"].is_number_integer())
        return failure(400, "this is no saved comment");
    store_.dropComment(request["id"].get<std::int64_t>());
    return {200, "application/json", "{}"};
}

Reply ClassView::preview(const std::string& body) const {
    const std::optional<std::string> text = readText(body, "text");
    if (!text) return failure(400, "this is no text");
    return {200, "application/json", textOf({{"html", report::markdownHtml(*text)}})};
}

}  // namespace ticker::session
