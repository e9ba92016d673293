#include <grader/lab/selftest/MistakeTables.h>
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tests/support/SlowRun.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace ticker::selftest {
namespace {

using Table = std::span<const FindingText* const>;

const std::filesystem::path kRoot{TICKER_SOURCE_DIR};

std::vector<corpus::Entry> catalogue() {
    return mistakesOf(corpus::readCatalogue(kRoot), {"T2.1", "T2.2"});
}

TEST(DistributedCatalogue, HasEveryFinding) {
    // Only code that behaves differently in renders and single questions gets these; it is in
    // grader/corpus/hostile.
    std::set<std::string, std::less<>> shown{"shadow.not-in-renders", "dof.picture-differs"};
    for (const corpus::Entry& mistake : catalogue())
        shown.insert(mistake.expected().finding());
    for (const Table table : {Table{tasks::kShadowFindings}, Table{tasks::kLensFindings}})
        for (const FindingText* text : table)
            EXPECT_TRUE(shown.contains(text->id))
                << "no entry of grader/corpus/mistakes or grader/corpus/accepted expects "
                << text->id << "; the format is in grader/corpus/README.md";
}

// A correct reading fails with a chance below 1e-9; a mistake that only statistics show is missed
// with a chance below 1e-3.
TEST(DistributedCatalogue, IsJudgedAsItSays) {
    MistakeRun run;
    run.fraction = tests::isSlowRun() ? 0.1 : 0.0125;
    run.seed = 20;
    const auto rows =
        runMistakes(catalogue(), build::Kit::besideProgram(), sandbox::Sandbox::best(), run);
    EXPECT_GE(rows.size(), 5U);
    for (const MistakeRow& row : rows)
        EXPECT_TRUE(row.asExpected) << tableOf(rows);
}

// Light that is computed for each sample fits looser readings, too, at the handout's settings. At
// other settings it fits only its own reading.
TEST(DistributedCatalogue, DoesNotWarnOfSettingsThatAreFollowed) {
    std::vector<corpus::Entry> entries = catalogue();
    std::erase_if(entries, [](const auto& entry) { return entry.name != "accepted-per-sample"; });
    ASSERT_EQ(entries.size(), 1U);
    const auto seeds = tests::isSlowRun() ? std::vector<std::uint64_t>{3, 16, 20, 22}
                                          : std::vector<std::uint64_t>{3};
    for (const std::uint64_t seed : seeds) {
        MistakeRun run;
        run.seed = seed;
        const auto rows =
            runMistakes(entries, build::Kit::besideProgram(), sandbox::Sandbox::best(), run);
        EXPECT_TRUE(rows.at(0).asExpected) << tableOf(rows);
    }
}

}  // namespace
}  // namespace ticker::selftest
