#include <grader/lab/selftest/Combinations.h>
#include <grader/lab/selftest/MistakeTables.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

namespace ticker::selftest {
namespace {

std::vector<corpus::Entry> accepted() {
    return corpus::readEntries(std::filesystem::path{TICKER_SOURCE_DIR}, {"accepted"});
}

TEST(Combinations, JoinChoicesWhoseEditsApplyTogetherEachOnce) {
    const std::vector<corpus::Entry> drawn = drawCombinations(accepted(), 40, 1);
    ASSERT_EQ(drawn.size(), 40U);
    std::set<std::string> names;
    for (const corpus::Entry& entry : drawn) {
        EXPECT_NE(entry.name.find('+'), std::string::npos);
        EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
        EXPECT_NO_THROW((void)corpus::textsOf(entry)) << entry.name;
    }
}

TEST(Combinations, LeaveOutWhatMustBeAlone) {
    std::vector<corpus::Entry> all = accepted();
    const auto alone =
        std::ranges::count_if(all, [](const auto& entry) { return !entry.alone.empty(); });
    EXPECT_GT(alone, 0);
    for (const corpus::Entry& entry : drawCombinations(all, 100, 2))
        EXPECT_EQ(entry.name.find("accepted-stratified"), std::string::npos) << entry.name;
    std::erase_if(all, [](const auto& entry) { return entry.alone.empty(); });
    EXPECT_TRUE(drawCombinations(all, 5, 3).empty());
}

TEST(Combinations, AreDrawnAnewFromAnotherSeed) {
    const auto first = [](std::uint64_t seed) {
        return drawCombinations(accepted(), 1, seed).at(0).name;
    };
    EXPECT_EQ(first(1), first(1));
    EXPECT_NE(first(1), first(2));
}

// Each combination fails with a chance below 1e-9.
TEST(Combinations, OfAcceptedReadingsPass) {
    MistakeRun run;
    run.seed = 7;
    const std::size_t count = 24;
    const auto rows = runMistakes(drawCombinations(accepted(), count, run.seed),
                                  build::Kit::besideProgram(), sandbox::Sandbox::best(), run);
    EXPECT_EQ(rows.size(), count);
    EXPECT_TRUE(std::ranges::all_of(rows, &MistakeRow::asExpected)) << tableOf(rows);
}

}  // namespace
}  // namespace ticker::selftest
