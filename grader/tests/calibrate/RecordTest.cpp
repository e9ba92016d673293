#include <grader/lab/calibrate/Record.h>
#include <grader/tests/calibrate/CountingCampaign.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace ticker::calibrate {
namespace {

TEST(Record, IsReadAgainInTheOrderOfTheUnits) {
    const tests::TemporaryFolder folder;
    const CountingCampaign campaign{5};
    {
        Record record{folder.path(), campaign};
        record.add(3, R"({"a":3})");
        record.add(1, R"({"a":1})");
    }
    const Record again{folder.path(), campaign};
    EXPECT_EQ(again.all(), (std::vector<std::string>{R"({"a":1})", R"({"a":3})"}));
    EXPECT_TRUE(again.has(3));
    EXPECT_FALSE(again.has(0));
}

// What is left of a line if the program was killed while it wrote it.
TEST(Record, DropsALineThatWasCutShort) {
    const tests::TemporaryFolder folder;
    const CountingCampaign campaign{5};
    {
        Record record{folder.path(), campaign};
        record.add(0, R"({"a":0})");
    }
    std::ofstream{folder.path() / "counting.jsonl", std::ios::app} << R"({"unit":"number 1","fou)";
    {
        Record record{folder.path(), campaign};
        EXPECT_EQ(record.size(), 1U);
        record.add(2, R"({"a":2})");
    }
    EXPECT_EQ(Record(folder.path(), campaign).all(),
              (std::vector<std::string>{R"({"a":0})", R"({"a":2})"}));
}

TEST(Record, IsNotChangedByReading) {
    const tests::TemporaryFolder folder;
    const CountingCampaign campaign{5};
    const std::filesystem::path file = folder.path() / "counting.jsonl";
    Record{folder.path(), campaign}.add(0, R"({"a":0})");
    std::ofstream{file, std::ios::app} << R"({"unit":"number 1","fou)";
    const auto size = std::filesystem::file_size(file);
    EXPECT_EQ(Record(folder.path(), campaign).size(), 1U);
    EXPECT_EQ(std::filesystem::file_size(file), size);
}

// Hours of work follow a bad line: an editor's slip must not drop them.
TEST(Record, NamesAWholeLineThatCannotBeRead) {
    for (const char* bad : {"{\"unit\"", "7", R"({"unit":1,"found":2})", R"({"unit":"number 1"})",
                            R"({"unit":"number 1","found":1,"code":2})", ""}) {
        const tests::TemporaryFolder folder;
        const CountingCampaign campaign{5};
        const std::filesystem::path file = folder.path() / "counting.jsonl";
        Record{folder.path(), campaign}.add(0, R"({"a":0})");
        std::ofstream{file, std::ios::app} << bad << '\n'
                                           << R"({"unit":"number 2","found":2})" << '\n';
        const auto size = std::filesystem::file_size(file);
        try {
            const Record record{folder.path(), campaign};
            FAIL() << bad;
        } catch (const raytracer::InputError& error) {
            EXPECT_NE(std::string{error.what()}.find("counting.jsonl:3: is no unit"),
                      std::string::npos)
                << error.what();
        }
        EXPECT_EQ(std::filesystem::file_size(file), size) << bad;
    }
}

// A second name of the earlier file keeps its bytes only if no one writes into that file.
TEST(Record, ReplacesAnEarlierCopyWhole) {
    const tests::TemporaryFolder folder;
    const CountingCampaign campaign{2};
    Record record{folder.path() / "own", campaign};
    record.add(0, R"({"a":0})");
    const std::filesystem::path copies = folder.path() / "copies";
    record.copyTo(copies);
    std::filesystem::create_hard_link(copies / "counting.jsonl", folder.path() / "earlier.jsonl");
    record.add(1, R"({"a":1})");
    record.copyTo(copies);
    EXPECT_EQ(Record(copies, campaign).size(), 2U);
    EXPECT_LT(std::filesystem::file_size(folder.path() / "earlier.jsonl"),
              std::filesystem::file_size(copies / "counting.jsonl"));
}

TEST(Record, LeavesACopyThatIsTheSameAsItIs) {
    const tests::TemporaryFolder folder;
    const CountingCampaign campaign{2};
    Record record{folder.path() / "own", campaign};
    record.add(0, R"({"a":0})");
    const std::filesystem::path copies = folder.path() / "copies";
    record.copyTo(copies);
    std::filesystem::create_hard_link(copies / "counting.jsonl", folder.path() / "earlier.jsonl");
    record.copyTo(copies);
    EXPECT_TRUE(
        std::filesystem::equivalent(copies / "counting.jsonl", folder.path() / "earlier.jsonl"));
}

TEST(Record, RefusesThatOfAnotherCampaign) {
    const tests::TemporaryFolder folder;
    std::ofstream{folder.path() / "counting.jsonl"} << R"({"campaign":"another"})" << '\n';
    EXPECT_THROW(Record(folder.path(), CountingCampaign{6}), raytracer::InputError);
}

TEST(Record, KeepsTheCodeThatAUnitBelongsTo) {
    const tests::TemporaryFolder folder;
    const CountingCampaign campaign{2};
    Record{folder.path(), campaign}.add(1, R"({"a":1})", {{"shadows", "12345678"}});
    const Record again{folder.path(), campaign};
    EXPECT_TRUE(again.isCurrent(1, {{"shadows", "12345678"}}));
    EXPECT_FALSE(again.isCurrent(1, {{"shadows", "12345679"}}));
    EXPECT_FALSE(again.isCurrent(0, {}));
}

TEST(Record, AdoptsWhatAnotherOneHasOfTodaysCode) {
    const tests::TemporaryFolder folder;
    const tests::TemporaryFolder other;
    const CountingCampaign campaign{3};
    const std::vector<Stamp> today(3, Stamp{{"lens", "new"}});
    Record committed{other.path(), campaign};
    committed.add(0, R"({"a":"committed"})", {{"lens", "new"}});
    committed.add(1, R"({"a":"committed"})", {{"lens", "old"}});
    committed.add(2, R"({"a":"committed"})", {{"lens", "old"}});
    Record record{folder.path(), campaign};
    record.add(0, R"({"a":"own"})", {{"lens", "old"}});
    record.add(1, R"({"a":"own"})", {{"lens", "new"}});
    record.adopt(committed, today);
    EXPECT_EQ(record.at(0), R"({"a":"committed"})");
    EXPECT_EQ(record.at(1), R"({"a":"own"})");
    EXPECT_EQ(record.at(2), R"({"a":"committed"})") << "old figures rather than none";
}

// A new entry of the catalogue must not invalidate the hours of work on the others.
TEST(Record, KnowsUnitsByNameWhenOthersComeAndGo) {
    const tests::TemporaryFolder folder;
    CountingCampaign campaign{3};
    {
        Record record{folder.path(), campaign};
        record.add(0, R"({"a":0})");
        record.add(2, R"({"a":2})");
    }
    campaign.firstUnit = 1;
    const Record later{folder.path(), campaign};
    EXPECT_EQ(later.size(), 1U);
    EXPECT_EQ(later.at(1), R"({"a":2})");
}

}  // namespace
}  // namespace ticker::calibrate
