#include <grader/store/Database.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <sqlite3.h>

#include <system_error>
#include <utility>

namespace ticker::store {
namespace fs = std::filesystem;
namespace {

constexpr int kPatienceMs = 10'000;  // another ticker's writes take milliseconds

// Advice for a broken file. Results are kept in folders of their own beside it.
constexpr const char* kWayOut =
    "; the results beside it are whole, decisions are in this file alone: move it away and run "
    "\"ticker collect OUT\", which brings the results back; sqlite3's .recover may save decisions";

constexpr const char* kNotWritable =
    "cannot be written; make it and its folder writable for you, or copy the folder";

bool isFileThere(const fs::path& file) {
    std::error_code error;
    return fs::exists(file, error);
}

/// The name under which SQLite reads a file without a lock and without files beside it.
std::string unchangingName(const fs::path& file) {
    std::string name = "file:";
    for (const char c : fs::absolute(file).lexically_normal().string())
        name += c == '/' ? "/" : fmt::format("%{:02x}", static_cast<unsigned char>(c));
    return name + "?immutable=1";
}

struct Close {
    void operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }
};
struct Finalize {
    void operator()(sqlite3_stmt* handle) const { sqlite3_finalize(handle); }
};

}  // namespace

struct Database::Connection {
    std::string file;
    std::unique_ptr<sqlite3, Close> handle;

    void open(const std::string& name, int flags) {
        sqlite3* opened = nullptr;
        const int status =
            sqlite3_open_v2(name.c_str(), &opened, flags | SQLITE_OPEN_FULLMUTEX, nullptr);
        handle.reset(opened);
        if (status != SQLITE_OK) fail();
        sqlite3_busy_timeout(opened, kPatienceMs);
    }

    [[nodiscard]] bool canBeRead() const {
        return sqlite3_exec(handle.get(), "SELECT 1 FROM sqlite_schema", nullptr, nullptr,
                            nullptr) == SQLITE_OK;
    }

    [[noreturn]] void fail() const {
        const int code = sqlite3_errcode(handle.get());
        std::string why = sqlite3_errmsg(handle.get());
        if (code == SQLITE_NOTADB || code == SQLITE_CORRUPT)
            throw raytracer::InputError(file, 0, why + kWayOut);
        if (code == SQLITE_READONLY || code == SQLITE_PERM ||
            (code == SQLITE_CANTOPEN && isFileThere(file)))
            throw raytracer::InputError(file, 0, kNotWritable);
        if (code == SQLITE_CANTOPEN) throw raytracer::InputError(file, 0, why);
        if (code == SQLITE_BUSY) why += "; another ticker has kept it locked";
        throw raytracer::Error(file + ": " + why);
    }
};

struct Statement::State {
    std::shared_ptr<Database::Connection> connection;
    std::unique_ptr<sqlite3_stmt, Finalize> handle;
    int bound = 0;

    void check(int status) const {
        if (status != SQLITE_OK) connection->fail();
    }
};

Statement& Statement::bind(std::string_view text) {
    state_->check(sqlite3_bind_text64(state_->handle.get(), ++state_->bound, text.data(),
                                      text.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
    return *this;
}

Statement& Statement::bind(std::int64_t number) {
    state_->check(sqlite3_bind_int64(state_->handle.get(), ++state_->bound, number));
    return *this;
}

Statement& Statement::bind(double number) {
    state_->check(sqlite3_bind_double(state_->handle.get(), ++state_->bound, number));
    return *this;
}

bool Statement::step() {
    const int status = sqlite3_step(state_->handle.get());
    if (status != SQLITE_ROW && status != SQLITE_DONE) state_->connection->fail();
    return status == SQLITE_ROW;
}

std::string Statement::text(int column) const {
    const auto* bytes = sqlite3_column_blob(state_->handle.get(), column);
    const int size = sqlite3_column_bytes(state_->handle.get(), column);
    return size == 0 ? std::string{}
                     : std::string{static_cast<const char*>(bytes), static_cast<std::size_t>(size)};
}

std::int64_t Statement::integer(int column) const {
    return sqlite3_column_int64(state_->handle.get(), column);
}

double Statement::real(int column) const {
    return sqlite3_column_double(state_->handle.get(), column);
}

Database::Database(const std::filesystem::path& file)
    : connection_(std::make_shared<Connection>()) {
    connection_->file = file.string();
    connection_->open(file.string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
    // The write-ahead log needs files beside this one even for reading. If they are missing
    // and this user cannot make them, no ticker has the file open.
    if (isReadOnly() && !connection_->canBeRead() && !isFileThere(file.string() + "-wal"))
        connection_->open(unchangingName(file), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
}

bool Database::isReadOnly() const {
    return sqlite3_db_readonly(connection_->handle.get(), "main") == 1;
}

Statement Database::prepare(std::string_view sql) const {
    auto state = std::make_shared<Statement::State>();
    state->connection = connection_;
    sqlite3_stmt* handle = nullptr;
    const int status = sqlite3_prepare_v2(connection_->handle.get(), sql.data(),
                                          static_cast<int>(sql.size()), &handle, nullptr);
    state->handle.reset(handle);
    state->check(status);
    return Statement{std::move(state)};
}

void Database::run(const std::string& sql) const {
    if (sqlite3_exec(connection_->handle.get(), sql.c_str(), nullptr, nullptr, nullptr) !=
        SQLITE_OK)
        connection_->fail();
}

Transaction::Transaction(const Database& database) : database_(database) {
    database_.run("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
    if (!isOpen_) return;
    try {
        database_.run("ROLLBACK");
    } catch (const raytracer::Error&) {
        // The error has rolled it back already.
        isOpen_ = false;
    }
}

void Transaction::commit() {
    database_.run("COMMIT");
    isOpen_ = false;
}

}  // namespace ticker::store
