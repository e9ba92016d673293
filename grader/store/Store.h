#ifndef TICKER_STORE_STORE_H
#define TICKER_STORE_STORE_H

#include <grader/result/Decision.h>
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

/// What the index of a class knows about one result; the rest stands in its result.json.
struct ResultRow {
    std::string submission;
    Verdict verdict = Verdict::notGraded;
    double score = 0.0;
    double maxScore = 1.0;
    std::string option;
    std::vector<std::string> findings;  ///< ids, of severity fail or warn
    std::string toolVersion;
    Inputs inputs;
    std::string gradedAt;          ///< UTC, "2026-11-21T16:05:36Z"
    std::int64_t timesGraded = 0;  ///< to the end, in this OUT
};

/// What became of a decision.
struct DecideOutcome {
    bool isKept = false;
    Decision current;  ///< the one that stands now: the new one, or the one that was in its way
};

/// OUT/results.sqlite: the index of a class, and its tickers' decisions. May be shared by threads,
/// and opened by several processes of one machine.
class Store {
public:
    /// Opens the store of OUT, or makes an empty one; OUT must be there.
    /// @param journal  For tests; otherwise as the file system needs it.
    /// @throws raytracer::InputError where the file is no store, or a newer ticker's.
    explicit Store(const std::filesystem::path& out, std::optional<Journal> journal = {});

    /// True where OUT has a store.
    [[nodiscard]] static bool isIn(const std::filesystem::path& out);

    /// A sentence for the user where WAL was refused; else empty.
    [[nodiscard]] const std::string& notice() const { return notice_; }

    /// Something to be remembered about the class, such as its seed. Empty: never set.
    [[nodiscard]] std::string remembered(std::string_view key) const;
    void remember(std::string_view key, std::string_view value);

    /// Keeps a result in one transaction. Its result.json should be there already.
    void put(const SubmissionResult& result, std::string_view gradedAt);
    [[nodiscard]] std::optional<ResultRow> find(std::string_view submission) const;
    /// All, by name.
    [[nodiscard]] std::vector<ResultRow> results() const;

    /// Keeps a decision unless somebody decided meanwhile: `decision.version` is the version that
    /// its author saw, and must still be the newest. On disk when this returns.
    DecideOutcome decide(const Decision& decision);
    /// The newest decision about each submission that has one, by name.
    [[nodiscard]] std::vector<Decision> decisions() const;
    /// All decisions about one submission, oldest first.
    [[nodiscard]] std::vector<Decision> history(std::string_view submission) const;

private:
    mutable std::mutex mutex_;
    Database database_;
    std::string notice_;
};

}  // namespace ticker::store

#endif
