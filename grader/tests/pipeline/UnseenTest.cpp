#include <grader/intake/Intake.h>
#include <grader/result/Names.h>
#include <grader/tests/pipeline/TestGrader.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

// Right and wrong solutions that were written without sight of the decision code.
namespace ticker::pipeline {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> unseenFolders() {
    std::vector<fs::path> folders;
    for (const char* kind : {"T1/right", "T1/wrong", "T2/right", "T2/wrong"})
        for (const auto& entry :
             fs::directory_iterator{fs::path{TICKER_SOURCE_DIR} / "grader/corpus/unseen" / kind})
            folders.push_back(entry.path());
    std::ranges::sort(folders);
    return folders;
}

std::string unseenName(const ::testing::TestParamInfo<fs::path>& unseen) {
    std::string name = unseen.param.filename().string();
    std::ranges::replace(name, '-', '_');
    return name;
}

class Unseen : public ::testing::TestWithParam<fs::path> {};

TEST_P(Unseen, GetsItsStateAndOneOfItsFindings) {
    const fs::path folder = GetParam();
    const auto expected = nlohmann::json::parse(std::ifstream{folder / "expected.json"});
    const auto located = intake::findSubmissions(folder);
    ASSERT_EQ(located.size(), 1U);

    const SubmissionResult result =
        gradeSubmission(intake::readSubmission(located[0]), tests::testGrader(), 20261121);

    for (const TaskReport& task : result.tasks) {
        if (!expected.at("tasks").contains(task.id)) continue;
        const auto& wanted = expected.at("tasks").at(task.id);
        EXPECT_EQ(toString(task.state), wanted.at("state")) << task.id << ": " << task.reason;
        if (!wanted.contains("findings")) continue;
        ASSERT_FALSE(task.findings.empty());
        const auto ids = wanted.at("findings").get<std::vector<std::string>>();
        EXPECT_NE(std::ranges::find(ids, task.findings.front().id), ids.end())
            << task.findings.front().id << ": " << task.findings.front().message;
    }
}

INSTANTIATE_TEST_SUITE_P(EverySolution, Unseen, ::testing::ValuesIn(unseenFolders()), unseenName);

}  // namespace
}  // namespace ticker::pipeline
