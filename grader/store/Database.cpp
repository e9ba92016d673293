#include <grader/store/Database.h>

#include <raytracer/base/Error.h>

#include <sqlite3.h>

#include <utility>

namespace ticker::store {
namespace {

constexpr int kPatienceMs = 10'000;  // another ticker's writes take milliseconds

// Advice for a broken file. Results are kept in folders of their own beside it.
constexpr const char* kWayOut =
    "; the results beside it are whole, decisions are in this file alone: move it away and run "
    "\"ticker collect OUT\", which brings the results back; sqlite3's .recover may save decisions";

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

    [[noreturn]] void fail() const {
        const int code = sqlite3_errcode(handle.get());
        std::string why = sqlite3_errmsg(handle.get());
        if (code == SQLITE_NOTADB || code == SQLITE_CORRUPT)
            throw raytracer::InputError(file, 0, why + kWayOut);
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
    sqlite3* handle = nullptr;
    const int status = sqlite3_open_v2(
        file.c_str(), &handle, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_FULLMUTEX,
        nullptr);
    connection_->handle.reset(handle);
    if (status != SQLITE_OK) connection_->fail();
    sqlite3_busy_timeout(handle, kPatienceMs);
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
