#include <grader/result/ResultJson.h>
#include <grader/store/Earlier.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

namespace ticker::store {
namespace {

namespace fs = std::filesystem;

SubmissionResult handedIn(const std::string& files, Verdict verdict) {
    SubmissionResult result;
    result.submission = "ann";
    result.verdict = verdict;
    result.inputs = {files, "bb", "cc"};
    return result;
}

class EarlierResults : public testing::Test {
protected:
    void write(const SubmissionResult& result, const std::string& code) const {
        out_.write("ann/result.json", resultJson(result));
        out_.write("ann/code/Own.cpp", code);
    }
    [[nodiscard]] std::vector<Earlier> earlier() const {
        return earlierResults(out_.path(), "ann");
    }

    tests::TemporaryFolder out_;
};

TEST_F(EarlierResults, StayWithTheirCodeWhenOtherFilesAreHandedIn) {
    EXPECT_TRUE(earlier().empty());
    keepEarlier(out_.path(), handedIn("aa", Verdict::notAwarded));  // the first one
    write(handedIn("aa", Verdict::notAwarded), "int a;");
    keepEarlier(out_.path(), handedIn("dd", Verdict::notAwarded));
    write(handedIn("dd", Verdict::notAwarded), "int b;");
    keepEarlier(out_.path(), handedIn("dd", Verdict::awarded));
    const std::vector<Earlier> all = earlier();
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].result.inputs.files, "dd") << "newest first";
    EXPECT_EQ(all[1].result.inputs.files, "aa");
    EXPECT_TRUE(fs::exists(all[1].code / "Own.cpp"));
    EXPECT_EQ(all[1].gradedAt.size(), std::string{"2026-11-21T16:05:36Z"}.size());
}

TEST_F(EarlierResults, DoNotPileUpWhereNothingHasChanged) {
    write(handedIn("aa", Verdict::awarded), "int a;");
    keepEarlier(out_.path(), handedIn("aa", Verdict::awarded));
    EXPECT_TRUE(earlier().empty());
    EXPECT_TRUE(fs::exists(out_.path() / "ann/result.json"));
}

TEST_F(EarlierResults, SurviveAKilledMove) {
    write(handedIn("aa", Verdict::awarded), "int a;");
    keepEarlier(out_.path(), handedIn("dd", Verdict::awarded));
    fs::create_directories(out_.path() / "ann/earlier/2");
    EXPECT_EQ(earlier().size(), 1U);
}

}  // namespace
}  // namespace ticker::store
