#include <grader/lab/selftest/HostileTables.h>
#include <grader/lab/selftest/Traces.h>
#include <grader/tests/support/SlowRun.h>

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>

#if defined(__SANITIZE_ADDRESS__)
// Freed memory that the sanitizer keeps back would count as memory that hostile code left behind.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
    return "quarantine_size_mb=8";
}
#endif

namespace ticker::selftest {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot{TICKER_SOURCE_DIR};

pipeline::Grader graderOf(sandbox::Sandbox sandbox) {
    pipeline::Grader grader{build::Kit::besideProgram(), sandbox,
                            sandbox::readPolicy(kRoot / "grader/corpus/hostile/limits.json"),
                            rubric::readRubric(kRoot / "grader/rubric/rubric.json"), "test"};
    // Some submissions answer rightly and render something else.
    grader.scenes = pipeline::readSpecScenes(kRoot / "scenes", kRoot / "assets");
    return grader;
}

std::vector<corpus::Entry> casesNamed(const std::vector<std::string>& names) {
    std::vector<corpus::Entry> cases;
    for (corpus::Entry& each : corpus::readEntries(kRoot, {"hostile"}))
        if (std::ranges::find(names, each.name) != names.end()) cases.push_back(std::move(each));
    return cases;
}

TEST(HostileTables, APartOfTheCorpusComesOutAsExpected) {
    HostileRun run;
    run.fraction = tests::isSlowRun() ? 0.03 : 0.015;
    run.rounds = 2;
    const HostileTables tables = runHostileTables(corpus::readEntries(kRoot, {"hostile"}),
                                                  graderOf(sandbox::Sandbox::best()), run);
    EXPECT_GE(tables.rows.size(), tests::isSlowRun() ? 10U : 6U);
    EXPECT_TRUE(tables.passed()) << tables.table();
}

TEST(HostileTables, SeeThatStateFindingAndVerdictAreOthersThanExpected) {
    auto cases = casesNamed({"abort"});
    ASSERT_EQ(cases.size(), 1U);
    cases[0].tasks["T1"] = {{"passed"}, {{"build.failed"}}, false};
    cases[0].verdicts = {"awarded"};

    const HostileTables tables =
        runHostileTables(cases, graderOf(sandbox::Sandbox::best()), HostileRun{});

    ASSERT_EQ(tables.rows.size(), 1U);
    EXPECT_EQ(tables.rows[0].faults.size(), 3U) << tables.table();
    EXPECT_FALSE(tables.passed());
    EXPECT_EQ(tables.right(), 0U);
}

// A missing finding must be reported even if the task passes.
TEST(HostileTables, SeeThatWhatHasToBeFoundIsNot) {
    auto cases = casesNamed({"archive-own-kit"});
    ASSERT_EQ(cases.size(), 1U);
    cases[0].tasks.begin()->second.findings = {"dof.picture-differs"};

    const HostileTables tables =
        runHostileTables(cases, graderOf(sandbox::Sandbox::best()), HostileRun{});

    ASSERT_EQ(tables.rows.size(), 1U);
    EXPECT_EQ(tables.rows[0].faults.size(), 1U) << tables.table();
}

TEST(HostileTables, GradeAFolderThatIsNamedLikeAFileOfTheResultsUnderAnotherName) {
    const HostileTables tables =
        runHostileTables(casesNamed({"named-in-capitals", "named-like-an-export"}),
                         graderOf(sandbox::Sandbox::best()), HostileRun{});
    EXPECT_EQ(tables.rows.size(), 2U);
    EXPECT_TRUE(tables.passed()) << tables.table();
}

// A table without a leaked secret proves little unless it would report one.
TEST(HostileTables, SeeASecretThatIsOut) {
    // Without confinement the compiler reads the file and quotes it.
    const auto cases = casesNamed({"include-secret"});

    const HostileTables tables =
        runHostileTables(cases, graderOf(sandbox::Sandbox::at(sandbox::Level::none)), HostileRun{});

    ASSERT_EQ(tables.rows.size(), 1U);
    EXPECT_EQ(tables.rows[0].faults, std::vector<std::string>{"the secret is out"})
        << tables.table();
}

TEST(LeftBehind, TellsEachThingThatThereIsMoreOf) {
    const Footprint before{0, 10, 20, 50.0, 10.0, 1000.0};
    EXPECT_EQ(leftBehind(before, {0, 10, 20, 140.0, 15.0, 100.0}), std::vector<std::string>{});
    EXPECT_EQ(
        leftBehind(before, {1, 12, 21, 140.0, 60.0, 1000.0}),
        (std::vector<std::string>{"1 processes more than before", "2 files more than before",
                                  "1 mounts more than before", "140 MB more memory than before"}));
}

TEST(ProcessesLeft, SeesAProcessWithAUidThatNoJailHolds) {
    if (geteuid() != 0) GTEST_SKIP() << "only root can give a process another uid";
    constexpr long kUser = 60950;  // outside the range of limits.json
    int ready[2];
    ASSERT_EQ(pipe(ready), 0);
    const pid_t child = fork();
    if (child == 0) {
        const bool changed = setuid(static_cast<uid_t>(kUser)) == 0;  // not dumpable after this
        if (!changed || write(ready[1], "x", 1) != 1) _exit(1);
        pause();
        _exit(0);
    }
    char byte = 0;
    EXPECT_EQ(read(ready[0], &byte, 1), 1);
    const auto left = processesLeft({kUser, 1});
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    EXPECT_EQ(left, std::vector<std::string>{"/proc/" + std::to_string(child)});
    EXPECT_EQ(processesLeft({kUser, 1}), std::vector<std::string>{});
}

}  // namespace
}  // namespace ticker::selftest
