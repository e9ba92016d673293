#include <grader/build/Build.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/corpus/Entry.h>
#include <grader/lab/selftest/MistakeTables.h>
#include <grader/tasks/Tasks.h>
#include <grader/tests/support/SlowRun.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace ticker::selftest {
namespace {

const Exercise& mainTick() {
    return exerciseNamed("tick1");
}

std::vector<corpus::Entry> entriesOf(const std::string& collection,
                                     const std::set<std::string>& names) {
    auto entries = corpus::readEntries(TICKER_SOURCE_DIR, {collection}, mainTick());
    std::erase_if(entries, [&](const corpus::Entry& entry) {
        return names.count(entry.group + "/" + entry.name) == 0;
    });
    EXPECT_EQ(entries.size(), names.size());
    return entries;
}

void expectJudgedAsTheySay(const std::vector<corpus::Entry>& entries, std::uint64_t seed) {
    MistakeRun run;
    run.exercise = &mainTick();
    run.seed = seed;
    for (const MistakeRow& row :
         runMistakes(entries, build::Kit::besideProgram(mainTick()), sandbox::Sandbox::best(), run))
        EXPECT_TRUE(row.asExpected) << row.entry.name << ", seed " << seed << ": " << row.seen;
}

// Two threads share the variable at every ray of four pictures. In 8 runs on a loaded machine 296
// or more of 768 pixels differed, and one is enough.
TEST(MainTickCatalogue, FindsVariablesThatThreadsShare) {
    const auto entries =
        entriesOf("mistakes", {"M2/static-sum", "M3.2/static-path", "M4/static-mirrored-ray"});
    for (std::uint64_t seed = 1; seed <= (tests::isSlowRun() ? 3U : 1U); ++seed)
        expectJudgedAsTheySay(entries, seed);
}

TEST(MainTickCatalogue, NamesTheseMistakesAlikeWhateverTheSeed) {
    const auto entries =
        entriesOf("mistakes", {"M1/root-not-taken", "M2/intensity-alone", "M3.1/static-point",
                               "M3.2/bias-whole-normal", "M3.2/from-viewer", "M4/two-lower"});
    for (std::uint64_t seed = 1; seed <= (tests::isSlowRun() ? 2U : 1U); ++seed)
        expectJudgedAsTheySay(entries, seed);
}

TEST(MainTickCatalogue, AnEntryMayNameWhatItDoesToAnotherTask) {
    expectJudgedAsTheySay(entriesOf("mistakes", {"M2/ambient-only", "M3.2/inverted"}), 1);
}

TEST(MainTickCatalogue, AnEntryMayBeWholeFilesOfWhichTheTasksOwnIsJudged) {
    expectJudgedAsTheySay(entriesOf("unseen", {"M4/highlights-from-first-viewer"}), 1);
}

/// Judges each entry's own task under the seeds below `seeds`, or under a twelfth of them if this
/// is not a slow run.
void expectUnderSeeds(std::uint64_t seeds, const std::vector<corpus::Entry>& entries,
                      TaskState state) {
    const build::Kit kit = build::Kit::besideProgram(mainTick());
    const sandbox::Sandbox sandbox = sandbox::Sandbox::best();
    const sandbox::Limits limits;
    const std::uint64_t end = tests::isSlowRun() ? seeds : seeds / 12;
    for (const corpus::Entry& entry : entries) {
        const std::string file{mainTick().fileOf(entry.task())};
        const build::BuildResult built =
            build::buildProgram(kit, sandbox, limits, file, corpus::textsOf(entry).at(file));
        ASSERT_TRUE(built.program) << built.diagnostics;
        build::SandboxedExaminee examinee{*built.program, sandbox, limits};
        for (const auto& task : tasks::tasksOf(mainTick().name)) {
            if (task.id != entry.task()) continue;
            for (std::uint64_t seed = 0; seed < end; ++seed)
                EXPECT_EQ(task.judge(examinee, seed).state, state)
                    << entry.name << ", seed " << seed;
        }
    }
}

// Single precision and small tolerances are right readings under every seed.
TEST(MainTickCatalogue, NeverFailsRightReadingsThatRound) {
    expectUnderSeeds(
        60,
        entriesOf("accepted", {"M1/floats", "M1/half-chord-floats", "M1/tolerance-millionth",
                               "M1/small-roots-dropped", "M3.1/floats", "M3.1/by-heights",
                               "M3.1/tolerance-thousandth", "M3.1/small-distances-dropped",
                               "M2/floats", "M2/floats-throughout", "M3.2/floats", "M4/floats"}),
        TaskState::passed);
}

TEST(MainTickCatalogue, NeverFailsRightShadowsThatNeedNoBias) {
    expectUnderSeeds(
        12,
        entriesOf("accepted",
                  {"M3.2/from-light", "M3.2/from-light-location", "M3.2/from-light-object",
                   "M3.2/from-light-object-strict", "M3.2/from-light-distance",
                   "M3.2/every-far-hit", "M3.2/every-other-object", "M3.2/bias-millionth"}),
        TaskState::passed);
}

TEST(MainTickCatalogue, NeverPassesHitsALittleBehindTheRay) {
    expectUnderSeeds(60,
                     entriesOf("mistakes", {"M1/behind-far-limit", "M1/inside-negative-hit",
                                            "M1/inside-negative-limit"}),
                     TaskState::failed);
}

TEST(MainTickCatalogue, NeverPassesShadowsThatRoundingDecides) {
    expectUnderSeeds(12,
                     entriesOf("mistakes", {"M3.2/closest-skips-near", "M3.2/closest-skips-own",
                                            "M3.2/from-light-exactly", "M3.2/no-bias"}),
                     TaskState::failed);
}

}  // namespace
}  // namespace ticker::selftest
