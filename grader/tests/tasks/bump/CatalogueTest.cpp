#include <grader/lab/selftest/BumpTables.h>
#include <grader/tasks/bump/JudgeBump.h>
#include <grader/tests/support/SlowRun.h>
#include <grader/tests/tasks/bump/StandIn.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace ticker::tests {
namespace {

std::string stateName(TaskState state) {
    switch (state) {
        case TaskState::passed:
            return "passed";
        case TaskState::failed:
            return "failed";
        case TaskState::blocked:
            return "blocked";
        default:
            return "other";
    }
}

TaskJudgement judgeCompiled(const CompiledMistake& mistake, std::uint64_t seed) {
    selftest::FunctionExaminee examinee(mistake.normalAt);
    return tasks::judgeBump(examinee, seed);
}

void expectThatItTellsWhatToLookAt(const Finding& finding) {
    EXPECT_GT(finding.message.size(), 40U);
    EXPECT_GT(finding.hint.size(), 40U);
    EXPECT_FALSE(finding.section.empty());
    EXPECT_FALSE(finding.evidence.empty());
}

TEST(BumpCatalogue, EveryMistakeGetsItsFindingAndAHint) {
    // In a quick run every fourth.
    const std::size_t step = isSlowRun() ? 1 : 4;
    const std::uint64_t last = isSlowRun() ? 42 : 41;
    const auto& catalogue = compiledCatalogue();
    for (std::size_t i = 0; i < catalogue.size(); i += step)
        for (std::uint64_t seed = 41; seed <= last; ++seed) {
            const CompiledMistake& mistake = catalogue[i];
            SCOPED_TRACE(mistake.id);
            const TaskJudgement judgement = judgeCompiled(mistake, seed);
            EXPECT_EQ(stateName(judgement.state), mistake.state) << judgement.reason;
            const std::string got = judgement.findings.empty() ? "" : judgement.findings.front().id;
            EXPECT_EQ(got, mistake.finding) << judgement.reason;
            if (!got.empty()) expectThatItTellsWhatToLookAt(judgement.findings.front());
        }
}

struct Told {
    std::string id;
    std::string message;  ///< a part of it
    std::string hint;     ///< likewise
};

// Earlier words about these mistakes misled their authors.
TEST(BumpCatalogue, TellsTheseMistakesInWordsThatMendThem) {
    const std::vector<Told> wanted{
        {"step-of-a-hundredth-of-u-and-v", "is lost inside of most", "Compare neighbouring texels"},
        {"stripe-where-x-is-nearly-zero", "Beside the plane x = 0", "atan2 takes any two numbers"},
        {"normal-hardly-counts", "the normal lies flat in the surface", "n is missing"},
        {"tangents-in-degrees", "", "std::sin and std::cos take radians"},
        {"inverted", "along both axes", "If your slopes are the neighbour minus this texel, leave"},
        {"swapped-tangents", "The axes are exchanged", "the tangents themselves are exchanged"},
        {"column-beyond-the-last", "outside the map", "(-1 % width() stays -1)"},
        {"crash-beside-inverted-u", "another mistake shows: Along u the bumps are inverted",
         "Then: One sign is wrong"},
        {"second-difference", "even slopes tilt nothing", "right + left - 2 times this texel"},
        {"slope-as-angle-doubled", "leans 90 degrees or more", "doubles the angle"},
        {"smaller-step-wins", "leave hardly any slope", "std::min the fall"},
        {"larger-step-wins", "leave hardly any slope", "std::max of the differences"},
        {"upside-down", "stands on its head", "look for 1 - v. Then the sign of the term with Bv"},
        {"tangent-space-normal", "without any slope", "belongs to a flat picture"},
        {"cross-products-left-out", "The axes are exchanged", "signs too, n - Bu Pu - Bv Pv"},
        {"points-inwards", "points into the sphere", "all terms of the sum have the wrong sign"},
        {"half-the-columns-negative", "outside the map", "u is negative there"},
        {"columns-turned-but-not-tangent", "Along u the bumps", "Is there a 1 - u"},
        {"unit-gradient", "not a number", "nothing but the whole sum"},
        {"signed-bytes", "", "int8_t"},
        {"dark-half-inverted", "", "no abs"},
        {"u-inverted-behind", "", "no abs in them"},
        {"longer-side-for-both", "", "the larger of both"},
        {"normal-forgotten", "the normal lies flat in the surface", "n is missing from the sum"},
        {"normal-forgotten-tangents", "not a number", "such as a sum without n"},
        {"tangents-twist-with-latitude", "turning with the row",
         "Pu and Pv turn away with latitude"},
        {"pv-turns-with-latitude", "turning with the row", "Pv turns away with latitude"},
        {"neighbour-a-step-along-pu", "turning with the row", "a step along Pu in space"},
        {"sides-divided-in-whole-numbers", "is lost inside of most", "of whole numbers is 0"},
        {"v-slope-two-columns-aside", "a column 2 columns away", "Both slopes begin"},
        {"u-slope-two-rows-aside", "a row 2 rows away", "Both slopes begin"}};
    for (const Told& told : wanted) {
        SCOPED_TRACE(told.id);
        const auto mistake = std::ranges::find(compiledCatalogue(), told.id, &CompiledMistake::id);
        ASSERT_NE(mistake, compiledCatalogue().end());
        const TaskJudgement judgement = judgeCompiled(*mistake, 41);
        ASSERT_FALSE(judgement.findings.empty());
        const Finding& finding = judgement.findings.front();
        EXPECT_NE(finding.message.find(told.message), std::string::npos) << finding.message;
        EXPECT_NE(finding.hint.find(told.hint), std::string::npos) << finding.hint;
    }
}

TEST(BumpCatalogue, SaysUnderEverySeedThatPartOfTheCentreIsMissing) {
    const auto mistake =
        std::ranges::find(compiledCatalogue(), "centre-x-left-out", &CompiledMistake::id);
    ASSERT_NE(mistake, compiledCatalogue().end());
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const TaskJudgement judgement = judgeCompiled(*mistake, seed);
        ASSERT_FALSE(judgement.findings.empty());
        const std::string& hint = judgement.findings.front().hint;
        EXPECT_NE(hint.find("position - centre()"), std::string::npos) << seed << ": " << hint;
    }
}

TEST(BumpCatalogue, KnowsEveryMistakeOfTheModelByTheSameFinding) {
    const std::vector<CompiledMistake>& catalogue = compiledCatalogue();
    for (const selftest::Mistake mistake : selftest::allMistakes()) {
        const auto same = std::find_if(catalogue.begin(), catalogue.end(),
                                       [mistake](const CompiledMistake& entry) {
                                           return entry.id == selftest::idOf(mistake);
                                       });
        ASSERT_NE(same, catalogue.end()) << selftest::idOf(mistake);
        EXPECT_EQ(same->finding, selftest::expectedFinding(mistake)) << same->id;
    }
}

}  // namespace
}  // namespace ticker::tests
