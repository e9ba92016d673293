#include <grader/intake/Intake.h>
#include <grader/result/Names.h>
#include <grader/tests/pipeline/ShareOfCorpus.h>
#include <grader/tests/pipeline/TestGrader.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace ticker::pipeline {
namespace {

std::string sampleName(const testing::TestParamInfo<corpus::Entry>& sample) {
    std::string name = sample.param.name;
    std::ranges::replace(name, '-', '_');
    return name;
}

// The findings that expected.json names; warnings and notes may change with the tool.
std::vector<std::string> failingIds(const TaskReport& task) {
    std::vector<std::string> ids;
    for (const Finding& finding : task.findings)
        if (finding.severity == Severity::fail) ids.push_back(finding.id);
    return ids;
}

class Sample : public testing::TestWithParam<corpus::Entry> {};

TEST_P(Sample, GetsTheVerdictOfItsFolderForTheReasonsThatItNames) {
    const corpus::Entry& sample = GetParam();
    const auto located = intake::findSubmissions(std::filesystem::path{sample.path}.parent_path());
    ASSERT_EQ(located.size(), 1U);

    Grader grader = tests::testGraderWithScenes();
    if (sample.name == "loops-for-ever") grader.policy = tests::testGrader().policy;

    const SubmissionResult result =
        gradeSubmission(intake::readSubmission(located[0]), grader, 20261121);

    EXPECT_EQ(sample.verdicts, std::vector<std::string>{sample.group});
    EXPECT_EQ(toString(result.verdict), sample.group);
    ASSERT_EQ(result.tasks.size(), 4U);
    for (const TaskReport& task : result.tasks) {
        const corpus::Expectation& wanted = sample.tasks.at(task.id);
        EXPECT_TRUE(wanted.allows(toString(task.state))) << task.id << ": " << task.reason;
        EXPECT_EQ(failingIds(task), wanted.findings.value())
            << task.id << ": " << task.reason
            << (task.findings.empty() ? "" : task.findings[0].message);
    }
}

INSTANTIATE_TEST_SUITE_P(EverySample, Sample, testing::ValuesIn(tests::shareOf("samples")),
                         sampleName);

}  // namespace
}  // namespace ticker::pipeline
