#include <grader/selftest/HostileTables.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace ticker::selftest {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot{TICKER_SOURCE_DIR};

pipeline::Grader graderOf(sandbox::Sandbox sandbox) {
    return {build::Kit::besideProgram(), sandbox,
            sandbox::readPolicy(kRoot / "grader/hostile/limits.json"),
            rubric::readRubric(kRoot / "grader/rubric/rubric.json"), "test"};
}

std::vector<hostile::HostileCase> casesNamed(const std::vector<std::string>& names) {
    std::vector<hostile::HostileCase> cases;
    for (hostile::HostileCase& each : hostile::listHostileCases(kRoot / "grader/hostile/cases"))
        if (std::ranges::find(names, each.name) != names.end()) cases.push_back(std::move(each));
    return cases;
}

TEST(HostileTables, APartOfTheCorpusComesOutAsExpected) {
    HostileRun run;
    run.fraction = 0.06;
    const HostileTables tables =
        runHostileTables(hostile::listHostileCases(kRoot / "grader/hostile/cases"),
                         graderOf(sandbox::Sandbox::best()), run);
    EXPECT_GE(tables.rows.size(), 10U);
    EXPECT_TRUE(tables.passed()) << tables.table();
}

TEST(HostileTables, SeeThatStateFindingAndVerdictAreOthersThanExpected) {
    auto cases = casesNamed({"abort"});
    ASSERT_EQ(cases.size(), 1U);
    cases[0].states = {"passed"};
    cases[0].findings = {"build.failed"};
    cases[0].verdicts = {"awarded"};

    const HostileTables tables =
        runHostileTables(cases, graderOf(sandbox::Sandbox::best()), HostileRun{});

    ASSERT_EQ(tables.rows.size(), 1U);
    EXPECT_EQ(tables.rows[0].faults.size(), 3U) << tables.table();
    EXPECT_FALSE(tables.passed());
    EXPECT_EQ(tables.right(), 0U);
}

// A table that finds no secret proves little unless it would find one.
TEST(HostileTables, SeeASecretThatIsOut) {
    // Where nothing locks the compiler in, it reads the file and quotes it.
    const auto cases = casesNamed({"include-secret"});

    const HostileTables tables =
        runHostileTables(cases, graderOf(sandbox::Sandbox::at(sandbox::Level::none)), HostileRun{});

    ASSERT_EQ(tables.rows.size(), 1U);
    EXPECT_EQ(tables.rows[0].faults, std::vector<std::string>{"the secret is out"})
        << tables.table();
}

}  // namespace
}  // namespace ticker::selftest
