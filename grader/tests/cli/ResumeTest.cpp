#include "GradedClass.h"

#include <grader/cli/FolderLock.h>
#include <grader/store/Store.h>

#include <unistd.h>
#include <csignal>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSize = 5;

class Resume : public GradedClass {
protected:
    [[nodiscard]] std::int64_t timesGraded(const std::string& out, const std::string& name) const {
        const auto row = store::Store{at(out)}.find(name);
        return row ? row->timesGraded : 0;
    }
};

TEST_F(Resume, KeepsWhatHasNotChangedAndGradesWhatHas) {
    EXPECT_EQ(countKept(run(gradeCommand("out"))), 0U);
    std::ofstream{at("class") / "ann" / "BumpySphere.cpp", std::ios::app} << "// later\n";
    fs::create_directory(at("class") / "late");
    fs::copy(at("class") / "ann" / "Renderer.cpp", at("class") / "late");

    const auto lines = run(gradeCommand("out", {"--resume"}));
    EXPECT_EQ(lines.size(), kSize + 1);
    EXPECT_EQ(countKept(lines), kSize - 1);
    EXPECT_NE(errors().find("4 kept from before"), std::string::npos) << errors();
    EXPECT_EQ(timesGraded("out", "ann"), 2);
    EXPECT_EQ(timesGraded("out", "late"), 1);
    EXPECT_EQ(timesGraded("out", "bob, jr"), 1);
    EXPECT_EQ(countKept(run(gradeCommand("out", {"--resume"}))), kSize + 1);
}

TEST_F(Resume, RegradesWhatItIsToldAndKeepsTheRest) {
    run(gradeCommand("out", {"--seed", "5"}));
    const nlohmann::json before = untimed(at("out") / "=1+1" / "result.json");

    EXPECT_EQ(countKept(run(gradeCommand("out", {"--regrade", "bump.inverted-u"}))), kSize - 1);
    EXPECT_EQ(timesGraded("out", "=1+1"), 2);
    EXPECT_EQ(untimed(at("out") / "=1+1" / "result.json"), before) << "the seed is remembered";

    EXPECT_EQ(countKept(run(gradeCommand("out", {"--regrade", "ann"}))), kSize - 1);
    EXPECT_EQ(timesGraded("out", "ann"), 2);
    EXPECT_EQ(countKept(run(gradeCommand("out", {"--regrade", "older"}))), kSize);
    EXPECT_EQ(run(gradeCommand("out", {"--regrade", "nobody"}), 2).size(), 0U);
    EXPECT_NE(errors().find("--regrade nobody"), std::string::npos) << errors();
}

TEST_F(Resume, TakesResultsOfAnotherSeedForOthers) {
    run(gradeCommand("out", {"--seed", "5"}));
    EXPECT_EQ(countKept(run(gradeCommand("out", {"--seed", "5"}))), kSize);
    EXPECT_EQ(countKept(run(gradeCommand("out", {"--seed", "6"}))), 0U);
}

TEST_F(Resume, RefusesAFolderThatAnotherRunGradesInto) {
    fs::create_directory(at("out"));
    {
        const FolderLock other{at("out")};
        EXPECT_EQ(run(gradeCommand("out"), 2).size(), 0U);
        EXPECT_NE(errors().find("another ticker is grading into it"), std::string::npos)
            << errors();
    }
    EXPECT_EQ(run(gradeCommand("out")).size(), kSize);
}

// No process has the number 999999999: process ids end at 4194304.
TEST_F(Resume, RemovesWhatAKilledOneWasWriting) {
    fs::create_directories(at("out") / "ann");
    const fs::path leftOver = at("out") / ".summary.csv.999999999.part";
    const fs::path page = at("out") / "ann" / ".student.html.999999999.part";
    const fs::path written = at("out") / (".summary.csv." + std::to_string(getpid()) + ".part");
    for (const fs::path& file : {leftOver, page, written})
        std::ofstream{file} << "submission,";
    const FolderLock lock{at("out")};
    EXPECT_FALSE(fs::exists(leftOver));
    EXPECT_FALSE(fs::exists(page)) << "a submission's page";
    EXPECT_TRUE(fs::exists(written)) << "another process is writing it";
}

TEST_F(Resume, GoesOnAfterCtrlC) {
    {
        RunningTicker ticker{gradeCommand("out", {"--seed", "5"}), at("errors").string()};
        ASSERT_TRUE(ticker.readLine());
        ticker.send(SIGINT);
        EXPECT_EQ(ticker.wait(), 130);
    }
    EXPECT_NE(errors().find("Go on with"), std::string::npos) << errors();
    EXPECT_NE(errors().find("--seed 5 --resume"), std::string::npos) << errors();
    EXPECT_TRUE(fs::exists(at("out") / "summary.csv"));
    const auto lines = run(gradeCommand("out", {"--seed", "5", "--resume"}));
    EXPECT_EQ(lines.size(), kSize);
    EXPECT_GE(countKept(lines), 1U);
    for (const store::ResultRow& row : store::Store{at("out")}.results())
        EXPECT_EQ(row.timesGraded, 1) << row.submission;
}

// The first submission is slow: it still runs when the other four are done.
TEST_F(Resume, OffersNothingMoreWhereCtrlCCameAfterTheLastHadBegun) {
    RunningTicker ticker{gradeCommand("out", {"--seed", "5"}), at("errors").string()};
    for (std::size_t i = 1; i < kSize; ++i)
        ASSERT_TRUE(ticker.readLine());
    ticker.send(SIGINT);
    EXPECT_EQ(ticker.wait(), 130);
    EXPECT_NE(errors().find("everything was graded"), std::string::npos) << errors();
    EXPECT_EQ(errors().find("--resume"), std::string::npos) << errors();
}

TEST_F(Resume, SaysThatARegradeBeginsAnewAfterCtrlC) {
    run(gradeCommand("out", {"--seed", "5"}));
    RunningTicker ticker{gradeCommand("out", {"--regrade", "all"}), at("errors").string()};
    ASSERT_TRUE(ticker.readLine());
    ticker.send(SIGINT);
    EXPECT_EQ(ticker.wait(), 130);
    EXPECT_NE(errors().find("they are kept, but --regrade grades those that it names again"),
              std::string::npos)
        << errors();
}

TEST_F(Resume, CollectsAllResultsButADamagedOne) {
    run(gradeCommand("out", {"--seed", "5"}));
    fs::remove(at("out") / "summary.csv");
    std::ofstream{at("out") / "ann" / "result.json"} << "{";
    run({"collect", at("out").string()}, 3);
    EXPECT_NE(errors().find("ann/result.json"), std::string::npos) << errors();
    const std::string summary = textOf(at("out") / "summary.csv");
    EXPECT_EQ(summary.find("\nann,"), std::string::npos) << summary;
    EXPECT_NE(summary.find("bob, jr"), std::string::npos) << summary;
}

TEST_F(Resume, CollectsWhatNodesWroteIntoTheSameSummary) {
    run(gradeCommand("local", {"--seed", "5"}));
    run(gradeCommand("nodes", {"--seed", "5", "--results-only"}));
    EXPECT_FALSE(fs::exists(at("nodes") / "results.sqlite"));
    EXPECT_FALSE(fs::exists(at("nodes") / "summary.csv"));
    run({"collect", at("nodes").string()});
    EXPECT_EQ(textOf(at("nodes") / "summary.csv"), textOf(at("local") / "summary.csv"));
    EXPECT_EQ(countKept(run(gradeCommand("nodes", {"--seed", "5"}))), kSize);
}

TEST_F(Resume, GoesOnWithTheSeedOfWhatWasCollected) {
    run(gradeCommand("out", {"--results-only", "--seed", "5"}));
    run({"collect", at("out").string()});
    EXPECT_EQ(countKept(run(gradeCommand("out", {"--resume"}))), kSize);
}

TEST_F(Resume, IsToldThatCollectedResultsHaveSeveralSeeds) {
    run(gradeCommand("out", {"--results-only", "--share", "1/2", "--seed", "5"}));
    run({"collect", at("out").string()});
    EXPECT_EQ(errors().find("more than one seed"), std::string::npos) << errors();
    run(gradeCommand("out", {"--results-only", "--share", "2/2", "--seed", "6"}));
    run({"collect", at("out").string()});
    EXPECT_NE(errors().find("more than one seed"), std::string::npos) << errors();
    EXPECT_EQ(countKept(run(gradeCommand("out", {"--resume"}))), 3U) << "those of the first seed";
}

TEST_F(Resume, GoesOnWithTheExerciseOfWhatWasCollected) {
    fs::create_directory(at("main"));
    fs::copy(
        fs::path{TICKER_SOURCE_DIR} / "grader/corpus/tick1/samples/notAwarded/template-untouched",
        at("main") / "ann", fs::copy_options::recursive);
    const std::string out = at("out").string();
    const std::vector<std::string> grade{
        "grade", at("main").string(), "-o", out, "--exercise", "tick1", "--seed", "5"};
    auto onNode = grade;
    onNode.emplace_back("--results-only");
    run(onNode);
    run({"collect", out});
    EXPECT_EQ(run(gradeCommand("out"), 2).size(), 0U);
    EXPECT_NE(errors().find("holds results of tick1;"), std::string::npos) << errors();
    auto again = grade;
    again.emplace_back("--resume");
    EXPECT_EQ(countKept(run(again)), 1U);
}

TEST_F(Resume, GradesAgainWhatWasNotGradedForOurReasons) {
    run(gradeCommand("out", {"--seed", "5"}));
    const fs::path file = at("out") / "ann" / "result.json";
    nlohmann::json result = nlohmann::json::parse(textOf(file));
    result["verdict"] = "notGraded";
    std::ofstream{file} << result;
    EXPECT_EQ(countKept(run(gradeCommand("out", {"--resume"}))), kSize - 1);
    EXPECT_EQ(untimed(file).at("verdict"), "notAwarded");
}

}  // namespace
}  // namespace ticker::cli
