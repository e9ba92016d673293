#ifndef TICKER_CLI_CLASSRUN_H
#define TICKER_CLI_CLASSRUN_H

#include <grader/cli/FolderLock.h>
#include <grader/intake/Intake.h>
#include <grader/result/SubmissionResult.h>
#include <grader/store/Store.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ticker::cli {

/// Which results of an earlier run are to be made again.
struct Regrade {
    std::vector<std::string> words;  ///< "all", "older", finding ids, submissions; empty: none
    std::string build;               ///< of the running tool: what "older" is measured against

    [[nodiscard]] bool concerns(const SubmissionResult& result) const;
};

/// A run over a class whose results stay in OUT: which of them still hold, and where new ones go.
class ClassRun {
public:
    /// Opens OUT's store, or makes OUT and its store.
    /// @param hasStore  False: only results are read and written, as a cluster's node must;
    ///                  `ticker collect` takes them into the store.
    /// @throws raytracer::InputError where OUT cannot be made, is no OUT, or is being graded into.
    ClassRun(std::filesystem::path out, Regrade regrade, bool hasStore);

    /// The seed of the run: the one given; else, where earlier results are to be kept, theirs; else
    /// a fresh one. It is remembered.
    [[nodiscard]] std::uint64_t settleSeed(std::optional<std::uint64_t> given, bool keepsResults,
                                           std::uint64_t fresh);

    /// @throws raytracer::InputError where a word of `regrade` is nobody's name and nobody's
    ///         finding: a typing error would regrade nothing and say nothing.
    void checkRegrade(const std::vector<intake::Located>& submissions) const;

    /// The result that still holds. Without `regrade`: one of the very same inputs. With it: one
    /// of the same files that is not to be made again. Never one that was notGraded.
    [[nodiscard]] std::optional<SubmissionResult> known(const std::string& submission,
                                                        const Inputs& inputs) const;

    /// Writes a fresh result's files.
    void write(const SubmissionResult& result) const;
    /// Puts a result into the store, where it is not yet.
    void index(const SubmissionResult& result, bool isKept);
    /// Writes summary.csv and index.html of the whole class; without a store, neither.
    void finish() const;

    /// What the user should know about the store; empty: nothing.
    [[nodiscard]] std::string notice() const { return store_ ? store_->notice() : ""; }
    /// How many results OUT's store has.
    [[nodiscard]] std::size_t size() const { return store_ ? store_->results().size() : 0; }

private:
    std::filesystem::path out_;
    Regrade regrade_;
    std::optional<FolderLock> lock_;
    std::optional<store::Store> store_;
};

}  // namespace ticker::cli

#endif
