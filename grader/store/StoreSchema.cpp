#include <grader/store/StoreSchema.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

namespace ticker::store {
namespace fs = std::filesystem;
namespace {

constexpr int kVersion = 3;

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

constexpr const char* kSecond = R"(
ALTER TABLE result ADD COLUMN tasks TEXT NOT NULL DEFAULT '';
ALTER TABLE decision ADD COLUMN notes TEXT NOT NULL DEFAULT '';
ALTER TABLE decision ADD COLUMN bulk TEXT NOT NULL DEFAULT '';
ALTER TABLE decision ADD COLUMN files TEXT NOT NULL DEFAULT '';
CREATE TABLE saved_comment (
    id INTEGER PRIMARY KEY AUTOINCREMENT, finding TEXT NOT NULL, text TEXT NOT NULL,
    who TEXT NOT NULL, at TEXT NOT NULL, UNIQUE (finding, text));
)";

constexpr const char* kThird = "ALTER TABLE result ADD COLUMN proven TEXT NOT NULL DEFAULT '';";

std::int64_t pragma(const Database& database, const char* name) {
    Statement statement = database.prepare(fmt::format("PRAGMA {}", name));
    return statement.step() ? statement.integer(0) : 0;
}

/// The journal's mode after a change of it. SQLite does not wait there for another process that
/// makes the same file, but at the beginning of a transaction.
std::string modeAfter(const Database& database, const char* change) {
    constexpr int kMostTries = 20;
    for (int tries = 1;; ++tries) {
        try {
            Statement statement = database.prepare(change);
            statement.step();
            return statement.text(0);
        } catch (const raytracer::Error&) {
            if (tries == kMostTries) throw;
        }
        Transaction{database}.commit();
    }
}

}  // namespace

std::string setJournal(const Database& database, Journal journal) {
    if (database.isReadOnly()) return {};
    const bool ahead = journal == Journal::writeAhead;
    const std::string mode =
        modeAfter(database, ahead ? "PRAGMA journal_mode = WAL" : "PRAGMA journal_mode = DELETE");
    if (ahead && mode == "wal") return {};
    return "results.sqlite lies on a file system of the network, where SQLite's write-ahead log is "
           "not safe: a rollback journal is used; let one machine at a time write here";
}

void refuseForeign(const Database& database, const fs::path& file) {
    // One statement, so that a store that another process makes meanwhile is seen whole or not.
    Statement found = database.prepare(
        "SELECT (SELECT user_version FROM pragma_user_version), count(*), "
        "sum(name IN ('class', 'result', 'decision')) FROM sqlite_schema");
    found.step();
    const bool isNew = found.integer(0) == 0;
    if (isNew ? found.integer(1) == 0 : found.integer(2) == 3) return;
    throw raytracer::InputError(
        file.string(), 0,
        "is a database of another program, not ticker's; move it away, then \"ticker collect OUT\" "
        "makes ticker's own from the results beside it");
}

void makeTables(const Database& database, const fs::path& file) {
    // What is complete can be read without rights to write.
    if (pragma(database, "user_version") == kVersion) return;
    Transaction transaction{database};
    const std::int64_t version = pragma(database, "user_version");
    if (version > kVersion)
        throw raytracer::InputError(file.string(), 0,
                                    "was written by a newer ticker; use that one");
    if (version == 0) database.run(kTables);
    if (version < 2) database.run(kSecond);
    if (version < 3) database.run(kThird);
    if (version < kVersion) database.run(fmt::format("PRAGMA user_version = {}", kVersion));
    transaction.commit();
}

}  // namespace ticker::store
