#ifndef TICKER_STORE_DATABASE_H
#define TICKER_STORE_DATABASE_H

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace ticker::store {

/// One SQL statement with its values. Uses its database, which must outlive it.
class Statement {
public:
    /// Values in the order of the question marks.
    Statement& bind(std::string_view text);
    Statement& bind(std::int64_t number);
    Statement& bind(double number);

    /// Goes to the next row. @return  False after the last row.
    /// @throws raytracer::Error if the database cannot do it; InputError if it is damaged.
    bool step();

    /// Columns of the row, counted from 0.
    [[nodiscard]] std::string text(int column) const;
    [[nodiscard]] std::int64_t integer(int column) const;
    [[nodiscard]] double real(int column) const;

private:
    friend class Database;
    struct State;
    explicit Statement(std::shared_ptr<State> state) : state_(std::move(state)) {}
    std::shared_ptr<State> state_;
};

/// An SQLite file. Errors name the file and are raytracer errors.
class Database {
public:
    /// Opens the file, or creates it. A file that this user may only read is opened for reading.
    /// @throws raytracer::InputError if it cannot be opened.
    explicit Database(const std::filesystem::path& file);

    /// True if this user may only read the file: writing throws an InputError.
    [[nodiscard]] bool isReadOnly() const;

    [[nodiscard]] Statement prepare(std::string_view sql) const;
    /// Runs statements that return no rows.
    void run(const std::string& sql) const;

private:
    struct Connection;
    std::shared_ptr<Connection> connection_;
    friend class Statement;
};

/// A transaction: rolled back on destruction unless it was committed.
class Transaction {
public:
    explicit Transaction(const Database& database);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    /// On return everything is on disk.
    void commit();

private:
    const Database& database_;
    bool isOpen_ = true;
};

}  // namespace ticker::store

#endif
