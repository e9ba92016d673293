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

/// A submission as the class has it: what the tool says, and what a person decided.
struct ClassEntry {
    SubmissionResult result;  ///< as result.json has it
    std::optional<Decision> decision;
};

/// `OUT/<submission>/result.json`
[[nodiscard]] std::filesystem::path resultFile(const std::filesystem::path& out,
                                               const std::string& submission);

/// The submission's result; empty where it is not there, or torn by a machine that lost its power.
[[nodiscard]] std::optional<SubmissionResult> readWholeResult(const std::filesystem::path& out,
                                                              const std::string& submission);

/// The whole class, by name: the submissions that OUT's store knows, or, where there is no store,
/// those that have a result.json. One whose folder somebody removed is left out.
/// @throws raytracer::InputError where OUT holds none, or a result.json cannot be read.
[[nodiscard]] std::vector<ClassEntry> readClass(const std::filesystem::path& out);

/// @throws raytracer::InputError saying what to do, where OUT's store has none of the results that
///         it should have: it is empty.
void expectResults(const std::filesystem::path& out, const Store& store);

/// What `collect` did.
struct Collected {
    std::size_t taken = 0;                ///< new, or other than what the store knew
    std::size_t known = 0;                ///< the store had them already
    std::vector<std::string> unreadable;  ///< one line each: the file and what is wrong with it
};

/// Takes the result.json files below OUT, written elsewhere, into OUT's store. Nothing is removed.
[[nodiscard]] Collected collect(const std::filesystem::path& out, Store& store);

/// This moment in UTC: "2026-11-21T16:05:36Z".
[[nodiscard]] std::string utcNow();

}  // namespace ticker::store

#endif
