#ifndef TICKER_SELFTEST_BUMPTABLES_H
#define TICKER_SELFTEST_BUMPTABLES_H

#include <grader/lab/selftest/BumpReadings.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ticker::selftest {

/// One line of a table that did not come out as it must.
struct Surprise {
    std::string mistake;  ///< "none" for a right reading
    std::string reading;
    std::uint64_t seed = 0;
    std::string expected;  ///< finding; empty: passed
    std::string got;
    std::string message;      ///< what the student would read
    bool passed = false;      ///< the judgement let it pass
    bool misleading = false;  ///< named something that is right as wrong
};

/// Counts over one row of a table.
struct TableRow {
    std::string name;
    std::string expected;
    int judged = 0;
    int passed = 0;
    int named = 0;  ///< the expected finding came first
    int misleading = 0;
};

/// What `./tick selftest --task T1` prints.
struct BumpSelfTest {
    std::vector<TableRow> accepted;  ///< a row for each kind of gain
    std::vector<TableRow> refused;   ///< a row for each mistake
    std::vector<Surprise> surprises;

    /// No accepted reading fails; no mistake passes; at least 98 % carry the expected name and none
    /// a misleading one.
    [[nodiscard]] bool passed() const;
    [[nodiscard]] std::string table() const;
};

/// Called after each judgement.
using Progress = std::function<void(int done, int total)>;

/// Judges the accepted readings and the mistakes in this process.
///
/// @param fraction  Share of the whole to judge, evenly spread: 0.1 judges every tenth.
/// @param seeds     Hidden draws: maps, spheres and points differ with each.
[[nodiscard]] BumpSelfTest runBumpSelfTest(double fraction, const std::vector<std::uint64_t>& seeds,
                                           const Progress& progress = {});

}  // namespace ticker::selftest

#endif
