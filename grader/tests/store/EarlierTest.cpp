#include <grader/result/ResultJson.h>
#include <grader/store/Earlier.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <sys/mount.h>

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

TEST_F(EarlierResults, AreNotDoubledWhereAFaultOfTheMachineCameBetween) {
    write(handedIn("aa", Verdict::awarded), "int a;");
    keepEarlier(out_.path(), handedIn("", Verdict::notGraded));
    write(handedIn("", Verdict::notGraded), "");
    ASSERT_EQ(earlier().size(), 1U) << "whose files could not be read is not known";
    keepEarlier(out_.path(), handedIn("aa", Verdict::awarded));
    EXPECT_TRUE(earlier().empty());
}

TEST_F(EarlierResults, StayWhereOthersFollowAFaultOfTheMachine) {
    write(handedIn("aa", Verdict::awarded), "int a;");
    keepEarlier(out_.path(), handedIn("dd", Verdict::notGraded));
    write(handedIn("dd", Verdict::notGraded), "int b;");
    keepEarlier(out_.path(), handedIn("dd", Verdict::notAwarded));
    ASSERT_EQ(earlier().size(), 1U);
    EXPECT_EQ(earlier()[0].result.inputs.files, "aa");
}

TEST_F(EarlierResults, AreNotReplacedWhereTheSameFilesCouldNotBeGradedAgain) {
    const auto isKept = [&](const std::string& files, Verdict verdict) {
        return keepsBefore(out_.path(), handedIn(files, verdict));
    };
    EXPECT_FALSE(isKept("aa", Verdict::notGraded)) << "there is none";
    write(handedIn("aa", Verdict::awarded), "int a;");
    EXPECT_TRUE(isKept("aa", Verdict::notGraded));
    EXPECT_FALSE(isKept("aa", Verdict::notAwarded));
    EXPECT_FALSE(isKept("dd", Verdict::notGraded)) << "another hand-in";
    EXPECT_FALSE(isKept("", Verdict::notGraded)) << "unknown files";
    write(handedIn("aa", Verdict::notGraded), "int a;");
    EXPECT_FALSE(isKept("aa", Verdict::notGraded)) << "no better one";
    write(handedIn("", Verdict::awarded), "int a;");
    EXPECT_FALSE(isKept("", Verdict::notGraded)) << "files that are not known are not the same";
}

TEST_F(EarlierResults, SurviveAKilledMove) {
    write(handedIn("aa", Verdict::awarded), "int a;");
    keepEarlier(out_.path(), handedIn("dd", Verdict::awarded));
    fs::create_directories(out_.path() / "ann/earlier/2");
    EXPECT_EQ(earlier().size(), 1U);
}

// The code is in OUT alone; the next grading removes what lies beside the result.
TEST_F(EarlierResults, KeepTheirCodeWhereverTheMoveWasKilled) {
    const fs::path ann = out_.path() / "ann";
    write(handedIn("aa", Verdict::awarded), "int a;");
    fs::create_directories(ann / "earlier/.new");
    fs::rename(ann / "code", ann / "earlier/.new/code");
    keepEarlier(out_.path(), handedIn("aa", Verdict::awarded));
    EXPECT_TRUE(fs::exists(ann / "code/Own.cpp")) << "the result has not moved";
    EXPECT_FALSE(fs::exists(ann / "earlier/.new"));
    EXPECT_TRUE(earlier().empty());

    fs::create_directories(ann / "earlier/.new");
    fs::rename(ann / "code", ann / "earlier/.new/code");
    fs::rename(ann / "result.json", ann / "earlier/.new/result.json");
    keepEarlier(out_.path(), handedIn("dd", Verdict::awarded));
    ASSERT_EQ(earlier().size(), 1U);
    EXPECT_TRUE(fs::exists(earlier()[0].code / "Own.cpp"));
}

TEST_F(EarlierResults, StayInTheirPlaceWhereTheyCannotBeMoved) {
    write(handedIn("aa", Verdict::awarded), "int a;");
    const fs::path blocking = out_.write("ann/earlier", "no folder");
    EXPECT_THROW(keepEarlier(out_.path(), handedIn("dd", Verdict::awarded)), raytracer::InputError);
    EXPECT_TRUE(fs::exists(out_.path() / "ann/result.json"));
    EXPECT_TRUE(fs::exists(out_.path() / "ann/code/Own.cpp"));
    fs::remove(blocking);
    keepEarlier(out_.path(), handedIn("dd", Verdict::awarded));
    EXPECT_EQ(earlier().size(), 1U);
}

TEST_F(EarlierResults, StayWithTheirCodeWhereThatCannotBeMoved) {
    write(handedIn("aa", Verdict::awarded), "int a;");
    const fs::path code = out_.path() / "ann/code";
    if (mount("none", code.c_str(), "tmpfs", 0, "size=1m") != 0)
        GTEST_SKIP() << "only root can make a folder that nobody can move";
    EXPECT_THROW(keepEarlier(out_.path(), handedIn("dd", Verdict::awarded)), raytracer::InputError);
    umount2(code.c_str(), MNT_DETACH);
    EXPECT_TRUE(fs::exists(out_.path() / "ann/result.json"));
    EXPECT_TRUE(earlier().empty());
}

TEST_F(EarlierResults, NeedNoCodeOfTheirOwn) {
    write(handedIn("aa", Verdict::awarded), "int a;");
    fs::remove_all(out_.path() / "ann/code");
    keepEarlier(out_.path(), handedIn("dd", Verdict::awarded));
    EXPECT_EQ(earlier().size(), 1U);
}

}  // namespace
}  // namespace ticker::store
