#ifndef TICKER_STORE_STORE_H
#define TICKER_STORE_STORE_H

#include <grader/result/Decision.h>
#include <grader/result/ProvenLine.h>
#include <grader/result/SubmissionResult.h>
#include <grader/store/Database.h>
#include <grader/store/Journal.h>

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::store {

/// The index's row for one result; the rest is in its result.json.
struct ResultRow {
    std::string submission;
    Verdict verdict = Verdict::notGraded;
    double score = 0.0;
    double maxScore = 1.0;
    std::string option;
    std::vector<std::string> findings;  ///< ids, of severity fail or warn
    std::string toolVersion;
    Inputs inputs;
    std::string gradedAt;            ///< UTC, "2026-11-21T16:05:36Z"
    std::int64_t timesGraded = 0;    ///< how often a result was stored in this OUT
    std::vector<std::string> tasks;  ///< "ID:passed", in the exercise's order
    std::vector<ProvenLine> proven;  ///< none where edits were not looked for
};

/// Words for students that the tickers of a class share.
struct SavedComment {
    std::int64_t id = 0;
    std::string finding;  ///< for submissions that have it; empty: for all
    std::string text;     ///< Markdown
    std::string who;      ///< who saved it
    std::string when;     ///< UTC
};

/// Result of storing a decision.
struct DecideOutcome {
    bool isKept = false;
    Decision current;  ///< the valid decision: the new one, or the conflicting one
};

/// OUT/results.sqlite: the index of a class, and its tickers' decisions. Threads may share it, and
/// several processes of one machine may open it.
class Store {
public:
    /// Opens the store of OUT, or creates an empty one; OUT must exist.
    /// @param journal  For tests; by default chosen for the file system.
    /// A store that this user may only read can be read; what writes throws InputError.
    /// @throws raytracer::InputError if the file is not a store, or belongs to a newer ticker.
    explicit Store(const std::filesystem::path& out, std::optional<Journal> journal = {});

    /// True where OUT has a store.
    [[nodiscard]] static bool isIn(const std::filesystem::path& out);

    /// A sentence for the user if WAL was refused; otherwise empty.
    [[nodiscard]] const std::string& notice() const { return notice_; }

    /// A stored value of the class, such as its seed; empty if it was never set.
    [[nodiscard]] std::string remembered(std::string_view key) const;
    void remember(std::string_view key, std::string_view value);

    /// Stores a result in one transaction. Its result.json should exist already.
    void put(const SubmissionResult& result, std::string_view gradedAt);
    [[nodiscard]] std::optional<ResultRow> find(std::string_view submission) const;
    /// All results, by name.
    [[nodiscard]] std::vector<ResultRow> results() const;

    /// Keeps each decision unless another one was made meanwhile: `version` is the version that its
    /// author saw, and must still be the newest. One transaction, on disk when this returns.
    std::vector<DecideOutcome> decide(const std::vector<Decision>& decisions);
    DecideOutcome decide(const Decision& decision) { return decide(std::vector{decision}).front(); }
    /// The newest decision about each submission that has one, by name.
    [[nodiscard]] std::vector<Decision> decisions() const;
    /// All decisions about one submission, oldest first.
    [[nodiscard]] std::vector<Decision> history(std::string_view submission) const;

    /// Stores a comment, unless the same text is stored for its finding already. On disk when this
    /// returns.
    void saveComment(const SavedComment& comment);
    void dropComment(std::int64_t id);
    /// All, oldest first.
    [[nodiscard]] std::vector<SavedComment> savedComments() const;

private:
    mutable std::mutex mutex_;
    Database database_;
    std::string notice_;
};

}  // namespace ticker::store

#endif
