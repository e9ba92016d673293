#ifndef TICKER_SELFTEST_BUMPTABLES_H
#define TICKER_SELFTEST_BUMPTABLES_H

#include <grader/lab/selftest/BumpReadings.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ticker::selftest {

/// One judgement with an unexpected result.
struct Surprise {
    std::string mistake;  ///< "none" for a right reading
    std::string reading;
    std::uint64_t seed = 0;
    std::string expected;  ///< finding; empty: passed
    std::string got;
    std::string message;      ///< the message for the student
    bool passed = false;      ///< the judgement was passed
    bool misleading = false;  ///< the finding calls something wrong that is right
};

/// Counts of one row of a table.
struct TableRow {
    std::string name;
    std::string expected;
    int judged = 0;
    int passed = 0;
    int named = 0;  ///< the expected finding came first
    int misleading = 0;
};

/// What `./tick selftest` prints.
struct BumpSelfTest {
    std::vector<TableRow> accepted;  ///< a row for each kind of gain
    std::vector<TableRow> refused;   ///< a row for each mistake
    std::vector<Surprise> surprises;

    /// True if no accepted reading fails, no mistake passes, at least 98 % get the expected finding
    /// and none a misleading one.
    [[nodiscard]] bool passed() const;
    [[nodiscard]] std::string table() const;
};

/// Called after each judgement.
using Progress = std::function<void(int done, int total)>;

/// Judges the accepted readings and the mistakes in this process.
///
/// @param fraction  Share of the judgements, evenly spread: 0.1 judges every tenth.
/// @param seeds     Seeds of the hidden draws: each gives other maps, spheres and points.
[[nodiscard]] BumpSelfTest runBumpSelfTest(double fraction, const std::vector<std::uint64_t>& seeds,
                                           const Progress& progress = {});

}  // namespace ticker::selftest

#endif
