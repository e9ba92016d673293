// Tables of docs/repairs.md, and the shares of the lab's tables.
#include <grader/corpus/Entry.h>
#include <grader/lab/EvenShare.h>
#include <grader/lab/repairs/RepairTables.h>

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace ticker::lab {
namespace {

RepairRow row(std::string collection, std::string name, bool isRepaired) {
    RepairRow made;
    made.collection = std::move(collection);
    made.task = "T1";
    made.name = std::move(name);
    made.isRepaired = isRepaired;
    return made;
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(EvenShare, IsSpreadAndHoldsAtLeastOne) {
    const std::vector<int> all{0, 1, 2, 3, 4, 5, 6, 7};
    EXPECT_EQ(evenShare(all, 1.0, 0.0), all);
    EXPECT_EQ(evenShare(all, 0.25, 0.0), (std::vector<int>{3, 7}));
    EXPECT_EQ(evenShare(all, 0.25, 0.5), (std::vector<int>{1, 5}));
    EXPECT_EQ(evenShare(all, 0.001, 0.5), std::vector<int>{0});
    EXPECT_TRUE(evenShare(std::vector<int>{}, 1.0, 0.5).empty());
}

TEST(RepairTables, SeveralMistakesAreCountedApartAndListedWithTheirReason) {
    const std::vector<RepairRow> rows{row("unseen", "slip", true), row("samples", "hard", false),
                                      row("unseen", "median", false)};
    const std::string tables = tablesOf(rows, {{"unseen/T1/median", "another algorithm"}});
    EXPECT_TRUE(holds(tables, "| unseen and samples, a single mistake | all | 2 | 1 of 2, 50.0 %"));
    EXPECT_TRUE(holds(tables, "| unseen and samples, several mistakes | all | 1 | 0 of 1"));
    EXPECT_TRUE(holds(tables, "| samples/hard | T1 | nothing |"));
    EXPECT_TRUE(holds(tables, "| unseen/median | T1 | nothing | another algorithm |"));
}

TEST(RepairTables, TakeThePlaceOfTheLastOnesAndLeaveTheRest) {
    const std::string document =
        "# Repairs\n<!-- repairs: tables -->\nold\n<!-- end -->\nBy hand.\n";
    EXPECT_EQ(withTables(document, "new\n"),
              "# Repairs\n<!-- repairs: tables -->\nnew\n<!-- end -->\nBy hand.\n");
    EXPECT_EQ(withTables("# Repairs\n", "new\n"),
              "# Repairs\n\n<!-- repairs: tables -->\nnew\n<!-- end -->\n");
}

TEST(SeveralMistakes, NameSubmissionsOfTheCorpusAndATaskThatTheyFail) {
    std::set<std::string> known;
    for (const Exercise& exercise : knownExercises())
        for (const corpus::Entry& entry :
             corpus::readEntries(TICKER_SOURCE_DIR, {"unseen", "samples"}, exercise))
            for (const auto& [task, expected] : entry.tasks)
                if (!expected.passes())
                    known.insert(entry.collection + "/" + task + "/" + entry.name);
    for (const auto& [name, why] : readSeveralMistakes(TICKER_SOURCE_DIR)) {
        EXPECT_TRUE(known.contains(name)) << name;
        EXPECT_FALSE(why.empty()) << name;
    }
}

}  // namespace
}  // namespace ticker::lab
