#ifndef TICKER_STORE_JOURNAL_H
#define TICKER_STORE_JOURNAL_H

#include <cstdint>
#include <filesystem>

namespace ticker::store {

/// SQLite's protection against reading incomplete writes.
enum class Journal {
    writeAhead,  ///< readers and a writer at the same time; needs shared memory
    rollback     ///< works wherever file locks work
};

/// True for the type of a network file system (statfs's f_type, linux/magic.h). Machines share no
/// memory there, and SQLite's WAL would lose data.
[[nodiscard]] bool isNetworkFileSystem(std::int64_t type);

/// The journal that is safe in a folder.
[[nodiscard]] Journal journalFor(const std::filesystem::path& folder);

}  // namespace ticker::store

#endif
