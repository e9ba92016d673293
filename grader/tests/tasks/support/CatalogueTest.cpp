#include <grader/lab/selftest/MistakeTables.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

namespace ticker::selftest {
namespace {

const std::filesystem::path kRoot{TICKER_SOURCE_DIR};

std::vector<corpus::Entry> catalogue() {
    return mistakesOf(corpus::readCatalogue(kRoot), {"T2.1", "T2.2"});
}

TEST(DistributedCatalogue, HasEveryFindingOfTheContract) {
    std::set<std::string> findings;
    for (const corpus::Entry& mistake : catalogue())
        findings.insert(mistake.expected().finding());
    for (const char* id : {"shadow.hard",
                           "shadow.too-few-rays",
                           "shadow.fixed-samples",
                           "shadow.inverted",
                           "shadow.all-or-nothing",
                           "shadow.ambient-scaled",
                           "shadow.specular-unshadowed",
                           "shadow.diffuse-unshadowed",
                           "shadow.lights-mixed",
                           "shadow.beyond-light",
                           "shadow.point-jittered",
                           "shadow.direction-offset",
                           "shadow.light-size",
                           "shadow.not-a-ball",
                           "shadow.clustered",
                           "shadow.threads-mixed",
                           "shadow.wrong",
                           "dof.none",
                           "dof.too-few-rays",
                           "dof.shared-samples",
                           "dof.not-averaged",
                           "dof.focal-distance",
                           "dof.focal-plane",
                           "dof.off-centre",
                           "dof.disc",
                           "dof.aperture-size",
                           "dof.reused-pattern",
                           "dof.wrong",
                           "settings.hard-coded"})
        EXPECT_EQ(findings.count(id), 1U) << id;
}

// A correct reading fails with a chance below 1e-9; a mistake that only statistics show is missed
// with a chance below 1e-3.
TEST(DistributedCatalogue, IsJudgedAsItSays) {
    MistakeRun run;
    run.fraction = 0.05;
    run.seed = 20;
    const auto rows =
        runMistakes(catalogue(), build::Kit::besideProgram(), sandbox::Sandbox::best(), run);
    EXPECT_GE(rows.size(), 7U);
    for (const MistakeRow& row : rows)
        EXPECT_TRUE(row.asExpected) << tableOf(rows);
}

// At the handout's settings light for each sample fits looser readings, too; at others only its
// own.
TEST(DistributedCatalogue, DoesNotWarnOfSettingsThatAreFollowed) {
    std::vector<corpus::Entry> entries = catalogue();
    std::erase_if(entries, [](const auto& entry) { return entry.name != "accepted-per-sample"; });
    ASSERT_EQ(entries.size(), 1U);
    for (const std::uint64_t seed : {3U, 16U, 20U, 22U}) {
        MistakeRun run;
        run.seed = seed;
        const auto rows =
            runMistakes(entries, build::Kit::besideProgram(), sandbox::Sandbox::best(), run);
        EXPECT_TRUE(rows.at(0).asExpected) << tableOf(rows);
    }
}

}  // namespace
}  // namespace ticker::selftest
