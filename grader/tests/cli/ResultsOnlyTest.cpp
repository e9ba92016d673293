// Runs without a store, as on a node of a cluster.
#include "GradedClass.h"

#include <csignal>
#include <string>

namespace ticker::cli {
namespace {

constexpr std::size_t kClassSize = 5;

using ResultsOnly = GradedClass;

TEST_F(ResultsOnly, RegradesTheFindingsOfItsResults) {
    run(gradeCommand("out", {"--results-only", "--seed", "5"}));
    const auto again = [&](const std::string& word, int status) {
        return run(gradeCommand("out", {"--results-only", "--seed", "5", "--regrade", word}),
                   status);
    };
    EXPECT_EQ(countKept(again("bump.inverted-u", 0)), kClassSize - 1);
    EXPECT_EQ(again("bump.flat", 2).size(), 0U);
    EXPECT_NE(errors().find("--regrade bump.flat"), std::string::npos) << errors();
}

TEST_F(ResultsOnly, SaysWithWhichSeedAStoppedRunGoesOn) {
    {
        RunningTicker ticker{gradeCommand("out", {"--results-only"}), at("errors").string()};
        ASSERT_TRUE(ticker.readLine());
        ticker.send(SIGINT);
        ASSERT_EQ(ticker.wait(), 130);
    }
    const std::string said = errors();
    const std::size_t begin = said.find(" --seed ");
    ASSERT_NE(begin, std::string::npos) << said;
    const std::size_t number = begin + std::string{" --seed "}.size();
    const std::string seed = said.substr(number, said.find(' ', number) - number);
    const auto lines = run(gradeCommand("out", {"--results-only", "--seed", seed, "--resume"}));
    EXPECT_EQ(lines.size(), kClassSize);
    EXPECT_GE(countKept(lines), 1U) << said;
}

}  // namespace
}  // namespace ticker::cli
