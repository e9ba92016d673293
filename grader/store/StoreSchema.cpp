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

}  // namespace

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
    if (version == 0) database.run(kTables);
    if (version < 2) database.run(kSecond);
    if (version < 3) database.run(kThird);
    if (version < kVersion) database.run(fmt::format("PRAGMA user_version = {}", kVersion));
    transaction.commit();
}

}  // namespace ticker::store
