// docs/for-instructors.md says of every known mistake whether the public tests notice it.
#include <grader/corpus/Catalogue.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace ticker {
namespace {

// A new mistake may wait for the next table.
TEST(CoverageTable, HasARowForNearlyEveryKnownMistake) {
    const std::string page = tests::readFile("docs/for-instructors.md");
    const std::filesystem::path catalogue =
        std::filesystem::path{TICKER_SOURCE_DIR} / "grader/corpus";
    int mistakes = 0;
    std::string missing;
    int missed = 0;
    for (const mistakes::Mistake& mistake : mistakes::readCatalogue(catalogue)) {
        if (mistake.expect.state == TaskState::passed) continue;
        ++mistakes;
        if (page.find("\n| " + mistake.id + " | ") != std::string::npos) continue;
        ++missed;
        missing += " " + mistake.id;
    }
    EXPECT_LT(missed * 20, mistakes)
        << "public_coverage --write docs/for-instructors.md adds" << missing;
    EXPECT_GT(mistakes, 150);
}

}  // namespace
}  // namespace ticker
