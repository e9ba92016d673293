#include <grader/store/Store.h>

#include <grader/result/Names.h>
#include <grader/result/Tally.h>
#include <grader/store/StoreSchema.h>

#include <fmt/core.h>

#include <sstream>
#include <system_error>

namespace ticker::store {
namespace fs = std::filesystem;
namespace {

constexpr const char* kFileName = "results.sqlite";

constexpr const char* kResultColumns =
    "submission, verdict, score, max_score, option, findings, tool_version, files, tool, how, "
    "graded_at, times_graded, tasks, proven";
constexpr const char* kDecisionColumns =
    "submission, version, ruling, comment, who, at, proposed, notes, bulk, files";

std::string findingsOf(const SubmissionResult& result) {
    std::string ids;
    for (const std::string& id : findingIds(result))
        ids += (ids.empty() ? "" : " ") + id;
    return ids;
}

std::string tasksOf(const SubmissionResult& result) {
    std::string states;
    for (const TaskReport& task : result.tasks)
        states += fmt::format("{}{}:{}", states.empty() ? "" : " ", task.id, toString(task.state));
    return states;
}

std::vector<std::string> words(const std::string& text) {
    std::istringstream stream{text};
    std::vector<std::string> all;
    for (std::string word; stream >> word;)
        all.push_back(word);
    return all;
}

ResultRow rowFrom(const Statement& found) {
    ResultRow row;
    row.submission = found.text(0);
    row.verdict = valueIn(kVerdictNames, found.text(1)).value_or(Verdict::notGraded);
    row.score = found.real(2);
    row.maxScore = found.real(3);
    row.option = found.text(4);
    row.findings = words(found.text(5));
    row.toolVersion = found.text(6);
    row.inputs = {found.text(7), found.text(8), found.text(9)};
    row.gradedAt = found.text(10);
    row.timesGraded = found.integer(11);
    row.tasks = words(found.text(12));
    row.proven = readProven(found.text(13));
    return row;
}

Decision decisionFrom(const Statement& found) {
    Decision decision;
    decision.submission = found.text(0);
    decision.version = found.integer(1);
    decision.ruling = valueIn(kRulingNames, found.text(2)).value_or(Ruling::undecided);
    decision.comment = found.text(3);
    decision.who = found.text(4);
    decision.when = found.text(5);
    decision.proposed = valueIn(kVerdictNames, found.text(6)).value_or(Verdict::needsReview);
    decision.notes = readNotes(found.text(7));
    decision.bulk = found.text(8);
    decision.files = found.text(9);
    return decision;
}

template <typename Read>
auto all(Statement statement, Read&& read) {
    std::vector<decltype(read(statement))> list;
    while (statement.step())
        list.push_back(read(statement));
    return list;
}

Decision newestOf(const Database& database, std::string_view submission) {
    Statement found = database.prepare(
        fmt::format("SELECT {} FROM decision WHERE submission = ? ORDER BY version DESC LIMIT 1",
                    kDecisionColumns));
    found.bind(submission);
    Decision none;
    none.submission = submission;
    return found.step() ? decisionFrom(found) : none;
}

DecideOutcome keep(const Database& database, const Decision& decision) {
    Decision current = newestOf(database, decision.submission);
    if (current.version != decision.version) return {false, std::move(current)};
    current = decision;
    ++current.version;
    database.prepare("INSERT INTO decision VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(current.submission)
        .bind(current.version)
        .bind(nameIn(kRulingNames, current.ruling))
        .bind(current.comment)
        .bind(current.who)
        .bind(current.when)
        .bind(toString(current.proposed))
        .bind(current.notes.empty() ? "" : notesText(current.notes))
        .bind(current.bulk)
        .bind(current.files)
        .step();
    return {true, std::move(current)};
}

}  // namespace

Store::Store(const fs::path& out, std::optional<Journal> journal) : database_(out / kFileName) {
    refuseForeign(database_, out / kFileName);
    notice_ = setJournal(database_, journal.value_or(journalFor(out)));
    database_.run("PRAGMA synchronous = FULL");
    makeTables(database_, out / kFileName);
}

bool Store::isIn(const fs::path& out) {
    std::error_code error;
    return fs::is_regular_file(out / kFileName, error);
}

std::string Store::remembered(std::string_view key) const {
    const std::lock_guard lock{mutex_};
    Statement found = database_.prepare("SELECT value FROM class WHERE key = ?");
    found.bind(key);
    return found.step() ? found.text(0) : "";
}

void Store::remember(std::string_view key, std::string_view value) {
    const std::lock_guard lock{mutex_};
    database_.prepare("INSERT OR REPLACE INTO class VALUES (?, ?)").bind(key).bind(value).step();
}

void Store::put(const SubmissionResult& result, std::string_view gradedAt) {
    const std::lock_guard lock{mutex_};
    Transaction transaction{database_};
    database_
        .prepare(
            "INSERT INTO result VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, 1, ?, ?) "
            "ON CONFLICT (submission) DO UPDATE SET verdict = excluded.verdict, "
            "score = excluded.score, max_score = excluded.max_score, "
            "option = excluded.option, findings = excluded.findings, "
            "tool_version = excluded.tool_version, files = excluded.files, "
            "tool = excluded.tool, how = excluded.how, graded_at = excluded.graded_at, "
            "tasks = excluded.tasks, proven = excluded.proven, "
            "times_graded = times_graded + 1")
        .bind(result.submission)
        .bind(toString(result.verdict))
        .bind(result.score)
        .bind(result.maxScore)
        .bind(result.option)
        .bind(findingsOf(result))
        .bind(result.toolVersion)
        .bind(result.inputs.files)
        .bind(result.inputs.tool)
        .bind(result.inputs.how)
        .bind(gradedAt)
        .bind(tasksOf(result))
        .bind(provenText(provenLines(result)))
        .step();
    transaction.commit();
}

std::optional<ResultRow> Store::find(std::string_view submission) const {
    const std::lock_guard lock{mutex_};
    Statement found = database_.prepare(
        fmt::format("SELECT {} FROM result WHERE submission = ?", kResultColumns));
    found.bind(submission);
    if (!found.step()) return std::nullopt;
    return rowFrom(found);
}

std::vector<ResultRow> Store::results() const {
    const std::lock_guard lock{mutex_};
    return all(
        database_.prepare(fmt::format("SELECT {} FROM result ORDER BY submission", kResultColumns)),
        rowFrom);
}

std::vector<DecideOutcome> Store::decide(const std::vector<Decision>& decisions) {
    const std::lock_guard lock{mutex_};
    Transaction transaction{database_};
    std::vector<DecideOutcome> outcomes;
    for (const Decision& decision : decisions)
        outcomes.push_back(keep(database_, decision));
    transaction.commit();
    return outcomes;
}

std::vector<Decision> Store::decisions() const {
    const std::lock_guard lock{mutex_};
    return all(database_.prepare(fmt::format(
                   "SELECT {} FROM decision AS d WHERE version = (SELECT max(version) FROM "
                   "decision WHERE submission = d.submission) ORDER BY submission",
                   kDecisionColumns)),
               decisionFrom);
}

std::vector<Decision> Store::history(std::string_view submission) const {
    const std::lock_guard lock{mutex_};
    Statement found = database_.prepare(fmt::format(
        "SELECT {} FROM decision WHERE submission = ? ORDER BY version", kDecisionColumns));
    found.bind(submission);
    return all(std::move(found), decisionFrom);
}

void Store::saveComment(const SavedComment& comment) {
    const std::lock_guard lock{mutex_};
    database_
        .prepare(
            "INSERT INTO saved_comment (finding, text, who, at) VALUES (?, ?, ?, ?) "
            "ON CONFLICT (finding, text) DO NOTHING")
        .bind(comment.finding)
        .bind(comment.text)
        .bind(comment.who)
        .bind(comment.when)
        .step();
}

void Store::dropComment(std::int64_t id) {
    const std::lock_guard lock{mutex_};
    database_.prepare("DELETE FROM saved_comment WHERE id = ?").bind(id).step();
}

std::vector<SavedComment> Store::savedComments() const {
    const std::lock_guard lock{mutex_};
    return all(
        database_.prepare("SELECT id, finding, text, who, at FROM saved_comment ORDER BY id"),
        [](const Statement& found) {
            return SavedComment{found.integer(0), found.text(1), found.text(2), found.text(3),
                                found.text(4)};
        });
}

}  // namespace ticker::store
