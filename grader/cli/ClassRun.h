#ifndef TICKER_CLI_CLASSRUN_H
#define TICKER_CLI_CLASSRUN_H

#include <grader/cli/FolderLock.h>
#include <grader/exercise/Exercise.h>
#include <grader/intake/Intake.h>
#include <grader/result/SubmissionResult.h>
#include <grader/store/Store.h>

#include <raytracer/base/Error.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ticker::cli {

/// Which results of an earlier run are graded again.
struct Regrade {
    std::vector<std::string> words;  ///< "all", "older", finding ids, submissions; empty: none
    std::string build;               ///< digest of the running tool, for "older"

    [[nodiscard]] bool concerns(const SubmissionResult& result) const;
};

/// Stores what a later run over OUT continues with: the results' exercise, and their seed if it is
/// the same for all.
/// @return  True if the results have one seed, or if there are no results.
/// @throws raytracer::InputError if the results are of more than one exercise.
bool rememberOrigin(store::Store& store, const std::vector<SubmissionResult>& results);

/// What OUT has of a submission after a run: the fresh result, one that was still valid, or one
/// that stays because the same files could not be graded anew.
enum class Stored { fresh, kept, before };

/// A run over a class with results in OUT: which results are still valid, and where new ones go.
class ClassRun {
public:
    /// Opens OUT's store, or creates OUT and its store.
    /// @param hasStore  False: only results are read and written, as on a cluster's node; `ticker
    ///                  collect` adds them to the store.
    /// @throws raytracer::InputError if OUT cannot be created, is not an OUT, is in use by another
    ///         run, or has results of another exercise.
    ClassRun(std::filesystem::path out, const Exercise& exercise, Regrade regrade, bool hasStore);

    /// The seed of the run: `given`; otherwise that of the earlier results if they are kept;
    /// otherwise `fresh`. It is stored.
    [[nodiscard]] std::uint64_t settleSeed(std::optional<std::uint64_t> given, bool keepsResults,
                                           std::uint64_t fresh);

    /// @throws raytracer::InputError if a word of `regrade` is neither a submission nor a finding.
    ///         A typing error would otherwise regrade nothing, silently.
    void checkRegrade(const std::vector<intake::Located>& submissions) const;

    /// The valid result of a submission. Without `regrade`: one with equal inputs. With it: one of
    /// the same files that is not to be regraded. Never one that was notGraded.
    [[nodiscard]] std::optional<SubmissionResult> known(const std::string& submission,
                                                        const Inputs& inputs) const;

    /// Writes a fresh result's files, unless OUT keeps the one that it has (`store::keepsBefore`).
    void write(const SubmissionResult& result) const;
    /// Stores a result: a fresh one that was written always, a kept one only if the store's row
    /// does not agree with it. Stores nothing without a store.
    /// @return  What OUT has of the submission now.
    [[nodiscard]] Stored index(const SubmissionResult& result, bool isKept);

    /// A notice for the user about the store, or no text.
    [[nodiscard]] std::string notice() const { return store_ ? store_->notice() : ""; }
    /// Number of results in OUT's store.
    [[nodiscard]] std::size_t size() const { return store_ ? store_->results().size() : 0; }

private:
    std::filesystem::path out_;
    Regrade regrade_;
    std::optional<FolderLock> lock_;
    std::optional<store::Store> store_;
};

/// Counts of the submissions that a run has finished so far.
struct RunCounts {
    std::map<Verdict, std::size_t> verdicts;
    std::size_t kept = 0;              ///< results of an earlier run
    std::size_t unexpected = 0;        ///< with another verdict than expected
    std::vector<std::string> notAnew;  ///< submissions that are `Stored::before`
    std::string whyNotAnew;            ///< of the first of them

    [[nodiscard]] std::size_t all() const;
};

/// The verdicts in a line, and the number of kept results in another one.
[[nodiscard]] std::string closingLine(const RunCounts& counts);

/// A notice about submissions that could not be graded anew, or no text.
[[nodiscard]] std::string notAnewLine(const RunCounts& counts);

/// The exit status of a run over a class.
/// @param stopped  Ctrl-C ended it.
[[nodiscard]] raytracer::ExitCode exitCodeOf(const RunCounts& counts, bool stopped);

}  // namespace ticker::cli

#endif
