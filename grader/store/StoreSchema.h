#ifndef TICKER_STORE_STORESCHEMA_H
#define TICKER_STORE_STORESCHEMA_H

#include <grader/store/Database.h>
#include <grader/store/Journal.h>

#include <filesystem>
#include <string>

namespace ticker::store {

/// Turns a journal on, unless the file may only be read. @return a sentence for the user where WAL
/// was refused; else empty.
[[nodiscard]] std::string setJournal(const Database& database, Journal journal);

/// Writes nothing. A file of ours has our tables, or none where it is new.
/// @throws raytracer::InputError where the file is another program's.
void refuseForeign(const Database& database, const std::filesystem::path& file);

/// Makes the tables of a new file, and adds to those of an older ticker what they lack.
/// @throws raytracer::InputError where a newer ticker wrote the file.
void makeTables(const Database& database, const std::filesystem::path& file);

}  // namespace ticker::store

#endif
