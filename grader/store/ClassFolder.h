#ifndef TICKER_STORE_CLASSFOLDER_H
#define TICKER_STORE_CLASSFOLDER_H

#include <grader/result/Decision.h>
#include <grader/result/SubmissionResult.h>
#include <grader/store/Store.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ticker::store {

/// A submission of a class: the tool's result and a ticker's decision.
struct ClassEntry {
    SubmissionResult result;  ///< as result.json has it
    std::optional<Decision> decision;
};

/// `OUT/<submission>/result.json`
[[nodiscard]] std::filesystem::path resultFile(const std::filesystem::path& out,
                                               const std::string& submission);

/// True if the store's row of a submission agrees with its result. A run that was killed between
/// writing the two leaves an older row, or none.
[[nodiscard]] bool isKnown(const std::optional<ResultRow>& row, const SubmissionResult& result);

/// The submission's result; empty if the file is missing or damaged (by a power failure, for
/// example).
[[nodiscard]] std::optional<SubmissionResult> readWholeResult(const std::filesystem::path& out,
                                                              const std::string& submission);

/// What `readClass` does about a result.json that cannot be read.
enum class Unreadable { fail, leaveOut };

/// The whole class, by name: the submissions in OUT's store, or, without a store, those with a
/// result.json. A submission whose folder was removed is left out.
/// @throws raytracer::InputError if OUT has no results, or a result.json cannot be read and is not
///         left out.
[[nodiscard]] std::vector<ClassEntry> readClass(const std::filesystem::path& out,
                                                Unreadable unreadable = Unreadable::fail);

/// @throws raytracer::InputError with advice if OUT's store is empty although it should have
///         results.
void expectResults(const std::filesystem::path& out, const Store& store);

/// Result of `collect`.
struct Collected {
    std::size_t taken = 0;                ///< new, or different from the store
    std::size_t known = 0;                ///< already in the store
    std::vector<std::string> unreadable;  ///< one line each: the file and its error
};

/// Adds the result.json files below OUT, written elsewhere, to OUT's store. Nothing is removed.
[[nodiscard]] Collected collect(const std::filesystem::path& out, Store& store);

/// The current time in UTC: "2026-11-21T16:05:36Z".
[[nodiscard]] std::string utcNow();

}  // namespace ticker::store

#endif
