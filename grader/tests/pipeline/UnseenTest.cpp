#include <grader/intake/Intake.h>
#include <grader/result/Names.h>
#include <grader/tests/pipeline/ShareOfCorpus.h>
#include <grader/tests/pipeline/TestGrader.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

// Right and wrong solutions that were written without knowledge of the checks.
namespace ticker::pipeline {
namespace {

std::string unseenName(const ::testing::TestParamInfo<corpus::Entry>& unseen) {
    std::string name = unseen.param.name;
    std::ranges::replace(name, '-', '_');
    return name;
}

class Unseen : public ::testing::TestWithParam<corpus::Entry> {};

TEST_P(Unseen, GetsItsStateAndOneOfItsFindings) {
    const corpus::Entry& unseen = GetParam();
    const auto located = intake::findSubmissions(std::filesystem::path{unseen.path}.parent_path());
    ASSERT_EQ(located.size(), 1U);

    const SubmissionResult result =
        gradeSubmission(intake::readSubmission(located[0]), tests::testGrader(), 20261121);

    for (const TaskReport& task : result.tasks) {
        const auto wanted = unseen.tasks.find(task.id);
        if (wanted == unseen.tasks.end()) continue;
        const Finding first = task.findings.empty() ? Finding{} : task.findings.front();
        EXPECT_TRUE(wanted->second.isMet(toString(task.state), first.id))
            << task.id << " " << toString(task.state) << ": " << task.reason << first.id << ": "
            << first.message;
    }
}

INSTANTIATE_TEST_SUITE_P(EverySolution, Unseen, ::testing::ValuesIn(tests::shareOf("unseen")),
                         unseenName);

}  // namespace
}  // namespace ticker::pipeline
