#include <grader/lab/calibrate/RunCampaign.h>
#include <grader/tests/calibrate/CountingCampaign.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

namespace ticker::calibrate {
namespace {

TEST(RunCampaign, DoesOnlyWhatTheRecordDoesNotHave) {
    const tests::TemporaryFolder folder;
    CountingCampaign campaign{20};
    Record record{folder.path(), campaign};
    record.add(7, R"({"square":49})");
    runCampaign(campaign, record, std::vector<Stamp>(20), 3, {});
    EXPECT_EQ(campaign.runs, 19);
    EXPECT_EQ(record.size(), 20U);
}

TEST(RunCampaign, RepeatsWhatIsOfOtherCode) {
    const tests::TemporaryFolder folder;
    CountingCampaign campaign{4};
    Record record{folder.path(), campaign};
    std::vector<Stamp> stamps(4, Stamp{{"shadows", "a"}});
    runCampaign(campaign, record, stamps, 1, {});
    stamps[2] = {{"shadows", "b"}};
    runCampaign(campaign, record, stamps, 1, {});
    EXPECT_EQ(campaign.runs, 5);
    EXPECT_EQ(currentUnits(record, stamps), 4U);
}

TEST(RunCampaign, RunsOnlyUnitsOfThatName) {
    const tests::TemporaryFolder folder;
    CountingCampaign campaign{20};
    Record record{folder.path(), campaign};
    runCampaign(campaign, record, std::vector<Stamp>(20), 1, {}, "number 1");
    EXPECT_EQ(campaign.runs, 11) << "1 and 10 to 19";
}

TEST(CheckCampaign, AcceptsTheSameResultsInAnotherCpuTime) {
    const tests::TemporaryFolder folder;
    CountingCampaign campaign{4};
    Record record{folder.path(), campaign};
    runCampaign(campaign, record, std::vector<Stamp>(4), 1, {});
    EXPECT_TRUE(checkCampaign(campaign, record, 2).empty());
    EXPECT_EQ(campaign.runs, 6);
}

TEST(CheckCampaign, TellsWhatCameOutDifferently) {
    const tests::TemporaryFolder folder;
    CountingCampaign campaign{4};
    Record record{folder.path(), campaign};
    record.add(0, R"({"square":0})");
    campaign.offset = 1;
    const std::vector<std::string> differences = checkCampaign(campaign, record, 1);
    ASSERT_EQ(differences.size(), 2U);
    EXPECT_NE(differences[0].find("counting, number 0: {"), std::string::npos);
    EXPECT_NE(differences[0].find(R"("square":1})"), std::string::npos) << "what came now";
    EXPECT_NE(differences[1].find("counting, number 2: nothing was recorded"), std::string::npos);
}

}  // namespace
}  // namespace ticker::calibrate
