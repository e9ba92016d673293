#include <grader/store/Store.h>

#include <grader/result/Names.h>
#include <grader/result/Tally.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <sstream>
#include <system_error>

namespace ticker::store {
namespace fs = std::filesystem;
namespace {

constexpr int kVersion = 1;
constexpr const char* kFileName = "results.sqlite";

constexpr const char* kTables = R"(
CREATE TABLE class (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE result (
    submission TEXT PRIMARY KEY, verdict TEXT NOT NULL, score REAL NOT NULL,
    max_score REAL NOT NULL, option TEXT NOT NULL, findings TEXT NOT NULL,
    tool_version TEXT NOT NULL, files TEXT NOT NULL, tool TEXT NOT NULL, how TEXT NOT NULL,
    graded_at TEXT NOT NULL, times_graded INTEGER NOT NULL) WITHOUT ROWID;
CREATE TABLE decision (
    submission TEXT NOT NULL, version INTEGER NOT NULL, ruling TEXT NOT NULL,
    comment TEXT NOT NULL, who TEXT NOT NULL, at TEXT NOT NULL, proposed TEXT NOT NULL,
    PRIMARY KEY (submission, version)) WITHOUT ROWID;
)";

constexpr const char* kResultColumns =
    "submission, verdict, score, max_score, option, findings, tool_version, files, tool, how, "
    "graded_at, times_graded";
constexpr const char* kDecisionColumns = "submission, version, ruling, comment, who, at, proposed";

std::string findingsOf(const SubmissionResult& result) {
    std::string ids;
    for (const std::string& id : findingIds(result))
        ids += (ids.empty() ? "" : " ") + id;
    return ids;
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
    return decision;
}

template <typename Read>
auto all(Statement statement, Read&& read) {
    std::vector<decltype(read(statement))> list;
    while (statement.step())
        list.push_back(read(statement));
    return list;
}

std::int64_t pragma(const Database& database, const char* name) {
    Statement statement = database.prepare(fmt::format("PRAGMA {}", name));
    return statement.step() ? statement.integer(0) : 0;
}

std::string setJournal(const Database& database, Journal journal) {
    const bool ahead = journal == Journal::writeAhead;
    Statement statement =
        database.prepare(ahead ? "PRAGMA journal_mode = WAL" : "PRAGMA journal_mode = DELETE");
    statement.step();
    const bool refused = ahead && statement.text(0) != "wal";
    if (ahead && !refused) return {};
    return "results.sqlite lies on a file system of the network, where SQLite's write-ahead log is "
           "not safe: a rollback journal is used; let one machine at a time write here";
}

// Called before the first write. Our files have our tables, or none if they are new.
void refuseForeign(const Database& database, const fs::path& file) {
    const bool isNew = pragma(database, "user_version") == 0;
    Statement isOurs = database.prepare(
        isNew ? "SELECT count(*) = 0 FROM sqlite_schema"
              : "SELECT count(*) = 3 FROM sqlite_schema WHERE name IN ('class', 'result', "
                "'decision')");
    if (isOurs.step() && isOurs.integer(0) != 0) return;
    throw raytracer::InputError(
        file.string(), 0,
        "is a database of another program, not ticker's; move it away, then \"ticker collect OUT\" "
        "makes ticker's own from the results beside it");
}

void makeTables(const Database& database, const fs::path& file) {
    Transaction transaction{database};
    const std::int64_t version = pragma(database, "user_version");
    if (version > kVersion)
        throw raytracer::InputError(file.string(), 0,
                                    "was written by a newer ticker; use that one");
    if (version == 0) {
        database.run(kTables);
        database.run(fmt::format("PRAGMA user_version = {}", kVersion));
    }
    transaction.commit();
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
            "INSERT INTO result VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, 1) "
            "ON CONFLICT (submission) DO UPDATE SET verdict = excluded.verdict, "
            "score = excluded.score, max_score = excluded.max_score, "
            "option = excluded.option, findings = excluded.findings, "
            "tool_version = excluded.tool_version, files = excluded.files, "
            "tool = excluded.tool, how = excluded.how, graded_at = excluded.graded_at, "
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

DecideOutcome Store::decide(const Decision& decision) {
    const std::lock_guard lock{mutex_};
    Transaction transaction{database_};
    Decision current = newestOf(database_, decision.submission);
    if (current.version != decision.version) return {false, std::move(current)};
    current = decision;
    ++current.version;
    database_.prepare("INSERT INTO decision VALUES (?, ?, ?, ?, ?, ?, ?)")
        .bind(current.submission)
        .bind(current.version)
        .bind(nameIn(kRulingNames, current.ruling))
        .bind(current.comment)
        .bind(current.who)
        .bind(current.when)
        .bind(toString(current.proposed))
        .step();
    transaction.commit();
    return {true, std::move(current)};
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

}  // namespace ticker::store
