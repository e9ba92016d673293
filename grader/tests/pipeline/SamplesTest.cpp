#include <grader/intake/Intake.h>
#include <grader/result/Names.h>
#include <grader/tests/pipeline/TestGrader.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace ticker::pipeline {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> sampleFolders() {
    std::vector<fs::path> folders;
    const fs::path root = fs::path{TICKER_SOURCE_DIR} / "grader/corpus/samples";
    for (const char* verdict : {"awarded", "notAwarded", "needsReview"})
        for (const auto& entry : fs::directory_iterator{root / verdict})
            folders.push_back(entry.path());
    std::ranges::sort(folders);
    return folders;
}

std::string sampleName(const testing::TestParamInfo<fs::path>& sample) {
    std::string name = sample.param.filename().string();
    std::ranges::replace(name, '-', '_');
    return name;
}

// What expected.json names: warnings and notes may come and go with the tool.
std::vector<std::string> failingIds(const TaskReport& task) {
    std::vector<std::string> ids;
    for (const Finding& finding : task.findings)
        if (finding.severity == Severity::fail) ids.push_back(finding.id);
    return ids;
}

class Sample : public testing::TestWithParam<fs::path> {};

TEST_P(Sample, GetsTheVerdictOfItsFolderForTheReasonsThatItNames) {
    const fs::path folder = GetParam();
    const auto expected = nlohmann::json::parse(std::ifstream{folder / "expected.json"});
    const auto located = intake::findSubmissions(folder);
    ASSERT_EQ(located.size(), 1U);

    const SubmissionResult result = gradeSubmission(intake::readSubmission(located[0]),
                                                    tests::testGraderWithScenes(), 20261121);

    EXPECT_EQ(toString(result.verdict), expected.at("verdict"));
    EXPECT_EQ(toString(result.verdict), folder.parent_path().filename().string());
    ASSERT_EQ(result.tasks.size(), 4U);
    for (const TaskReport& task : result.tasks) {
        const auto& wanted = expected.at("tasks").at(task.id);
        EXPECT_EQ(toString(task.state), wanted.at("state")) << task.id << ": " << task.reason;
        EXPECT_EQ(failingIds(task), wanted.at("findings").get<std::vector<std::string>>())
            << task.id << ": " << task.reason
            << (task.findings.empty() ? "" : task.findings[0].message);
    }
}

INSTANTIATE_TEST_SUITE_P(EverySample, Sample, testing::ValuesIn(sampleFolders()), sampleName);

}  // namespace
}  // namespace ticker::pipeline
