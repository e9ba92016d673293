#ifndef TICKER_STORE_JOURNAL_H
#define TICKER_STORE_JOURNAL_H

#include <cstdint>
#include <filesystem>

namespace ticker::store {

/// How SQLite keeps a half-done write from being seen.
enum class Journal {
    writeAhead,  ///< readers and a writer at the same time; needs memory that processes share
    rollback     ///< works wherever file locks work
};

/// True for the type of a file system (statfs's f_type, linux/magic.h) that other machines write
/// to. There no memory is shared, and SQLite's WAL would lose data.
[[nodiscard]] bool isNetworkFileSystem(std::int64_t type);

/// The journal that is safe in a folder.
[[nodiscard]] Journal journalFor(const std::filesystem::path& folder);

}  // namespace ticker::store

#endif
