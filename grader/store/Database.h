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

    /// Goes to the next row. @return false: there is none.
    /// @throws raytracer::Error where the database cannot do it; InputError where it is damaged.
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

/// An SQLite file. Its errors name the file and come as raytracer errors.
class Database {
public:
    /// Opens the file, or makes it.
    /// @throws raytracer::InputError where it cannot be opened.
    explicit Database(const std::filesystem::path& file);

    [[nodiscard]] Statement prepare(std::string_view sql) const;
    /// Runs statements that give no rows.
    void run(const std::string& sql) const;

private:
    struct Connection;
    std::shared_ptr<Connection> connection_;
    friend class Statement;
};

/// All or nothing: what is written during its life is undone at its end, unless it was committed.
class Transaction {
public:
    explicit Transaction(const Database& database);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    /// When this returns, everything is on disk.
    void commit();

private:
    const Database& database_;
    bool isOpen_ = true;
};

}  // namespace ticker::store

#endif
