#include <grader/result/ProvenLine.h>
#include <grader/result/ResultJson.h>
#include <grader/store/ClassFolder.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

namespace ticker::store {
namespace {

SubmissionResult resultOf(const std::string& name, Verdict verdict) {
    SubmissionResult result;
    result.submission = name;
    result.verdict = verdict;
    result.toolVersion = "0.1.0";
    result.inputs = {"aa", "bb", "cc"};
    return result;
}

/// An OUT folder as nodes of a cluster leave it: results and no store.
class ClassFolder : public testing::Test {
protected:
    void writeResult(const std::string& name, Verdict verdict) const {
        out_.write(name + "/result.json", resultJson(resultOf(name, verdict)));
    }

    tests::TemporaryFolder out_;
};

TEST_F(ClassFolder, IsCollectedIntoTheStoreAndOnlyOnce) {
    writeResult("ann", Verdict::awarded);
    writeResult("bob", Verdict::notAwarded);
    Store store{out_.path()};
    EXPECT_EQ(collect(out_.path(), store).taken, 2U);
    EXPECT_EQ(store.find("ann")->verdict, Verdict::awarded);
    writeResult("bob", Verdict::awarded);
    const Collected again = collect(out_.path(), store);
    EXPECT_EQ(again.taken, 1U);
    EXPECT_EQ(again.known, 1U);
    EXPECT_EQ(store.find("bob")->verdict, Verdict::awarded);
    EXPECT_EQ(store.find("ann")->timesGraded, 1);
}

TEST_F(ClassFolder, IsCollectedAgainOnceEditsThatMendItWereFound) {
    writeResult("ann", Verdict::notAwarded);
    Store store{out_.path()};
    static_cast<void>(collect(out_.path(), store));
    SubmissionResult explained = resultOf("ann", Verdict::notAwarded);
    explained.repairs =
        std::vector<Repair>{{"T1", "bump.flat", "BumpySphere.cpp", {{7, "a", "b"}}, true, ""}};
    out_.write("ann/result.json", resultJson(explained));
    EXPECT_EQ(collect(out_.path(), store).taken, 1U);
    EXPECT_EQ(store.find("ann")->proven, provenLines(explained));
    EXPECT_EQ(collect(out_.path(), store).known, 1U);
}

TEST_F(ClassFolder, SaysOfAnEmptyStoreWhatBringsTheResultsBack) {
    const Store store{out_.path()};
    const auto complaint = [&] {
        try {
            expectResults(out_.path(), store);
        } catch (const raytracer::InputError& error) {
            return std::string{error.what()};
        }
        return std::string{"none"};
    };
    EXPECT_NE(complaint().find("holds no results"), std::string::npos) << complaint();
    writeResult("ann", Verdict::awarded);
    EXPECT_NE(complaint().find("ticker collect OUT"), std::string::npos) << complaint();
    EXPECT_THROW(static_cast<void>(readClass(out_.path())), raytracer::InputError);
}

TEST_F(ClassFolder, NamesResultsThatCannotBeReadAndCollectsTheRest) {
    writeResult("ann", Verdict::awarded);
    out_.write("bob/result.json", "{\"schemaVersion\": 1, \"subm");
    out_.write("cy/result.json", resultJson(resultOf("ann", Verdict::awarded)));
    Store store{out_.path()};
    const Collected collected = collect(out_.path(), store);
    EXPECT_EQ(collected.taken, 1U);
    ASSERT_EQ(collected.unreadable.size(), 2U);
    EXPECT_NE(collected.unreadable[0].find("bob/result.json"), std::string::npos);
    EXPECT_NE(collected.unreadable[1].find("\"ann\""), std::string::npos);
    EXPECT_EQ(store.results().size(), 1U);
}

TEST_F(ClassFolder, NamesAResultWithoutAScoreAndCollectsTheRest) {
    writeResult("ann", Verdict::awarded);
    std::string text = resultJson(resultOf("bob", Verdict::awarded));
    const std::size_t begin = text.find(": ", text.find("\"score\"")) + 2;
    out_.write("bob/result.json",
               text.replace(begin, text.find_first_of(",\n", begin) - begin, "null"));
    Store store{out_.path()};
    const Collected collected = collect(out_.path(), store);
    EXPECT_EQ(collected.taken, 1U);
    ASSERT_EQ(collected.unreadable.size(), 1U);
    EXPECT_NE(collected.unreadable[0].find("/score: expected a number"), std::string::npos);
}

TEST_F(ClassFolder, IsReadWithTheDecisionsOfTheStore) {
    writeResult("ann", Verdict::awarded);
    writeResult("bob", Verdict::needsReview);
    {
        Store store{out_.path()};
        static_cast<void>(collect(out_.path(), store));
        static_cast<void>(
            store.decide({"bob", 0, Ruling::awarded, "", "ann", utcNow(), Verdict::needsReview}));
    }
    const std::vector<ClassEntry> entries = readClass(out_.path());
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_FALSE(entries[0].decision);
    ASSERT_TRUE(entries[1].decision);
    EXPECT_EQ(entries[1].decision->ruling, Ruling::awarded);
    EXPECT_EQ(entries[1].result.verdict, Verdict::needsReview);
}

TEST_F(ClassFolder, IsReadWithoutAStoreToo) {
    EXPECT_THROW(static_cast<void>(readClass(out_.path())), raytracer::InputError);
    writeResult("bob", Verdict::awarded);
    writeResult("ann", Verdict::awarded);
    ASSERT_EQ(readClass(out_.path()).size(), 2U);
    EXPECT_EQ(readClass(out_.path())[0].result.submission, "ann");
    EXPECT_FALSE(Store::isIn(out_.path())) << "reading makes none";
}

TEST_F(ClassFolder, LeavesOutASubmissionWhoseFolderWasRemoved) {
    writeResult("ann", Verdict::awarded);
    writeResult("bob", Verdict::awarded);
    Store store{out_.path()};
    static_cast<void>(collect(out_.path(), store));
    std::filesystem::remove_all(out_.path() / "ann");
    EXPECT_EQ(readClass(out_.path()).size(), 1U);
}

TEST_F(ClassFolder, GivesNoResultThatIsTorn) {
    writeResult("ann", Verdict::awarded);
    const std::string overridden = "b\xE2\x80\xAEob";  // result.json holds no such character
    writeResult(overridden, Verdict::awarded);
    EXPECT_EQ(readWholeResult(out_.path(), "ann")->inputs, (Inputs{"aa", "bb", "cc"}));
    EXPECT_EQ(readWholeResult(out_.path(), overridden)->submission, overridden);
    EXPECT_FALSE(readWholeResult(out_.path(), "nobody"));
    out_.write("ann/result.json", "");
    EXPECT_FALSE(readWholeResult(out_.path(), "ann"));
}

TEST(UtcNow, HasTheFormOfIso8601) {
    const std::string now = utcNow();
    ASSERT_EQ(now.size(), 20U) << now;
    EXPECT_EQ(now[10], 'T');
    EXPECT_EQ(now.back(), 'Z');
}

}  // namespace
}  // namespace ticker::store
