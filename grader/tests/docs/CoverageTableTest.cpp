// docs/for-instructors.md says of every known mistake whether the public tests notice it.
#include <grader/mistakes/Catalogue.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace ticker {
namespace {

TEST(CoverageTable, HasARowForEveryKnownMistake) {
    const std::string page = tests::readFile("docs/for-instructors.md");
    const std::filesystem::path catalogue =
        std::filesystem::path{TICKER_SOURCE_DIR} / "grader/mistakes";
    int mistakes = 0;
    for (const mistakes::Mistake& mistake : mistakes::readCatalogue(catalogue)) {
        if (mistake.expect.state == TaskState::passed) continue;
        EXPECT_NE(page.find("\n| " + mistake.id + " | "), std::string::npos)
            << mistake.id << ": public_coverage --write docs/for-instructors.md adds it";
        ++mistakes;
    }
    EXPECT_GT(mistakes, 150);
}

}  // namespace
}  // namespace ticker
