// docs/public-tests.md lists every known mistake and whether the public tests notice it.
#include <grader/corpus/Entry.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace ticker {
namespace {

// A new mistake may be missing until the table is written again.
TEST(CoverageTable, HasARowForNearlyEveryKnownMistake) {
    const std::string page = tests::readFile("docs/public-tests.md");
    int mistakes = 0;
    std::string missing;
    int missed = 0;
    for (const corpus::Entry& mistake : corpus::readCatalogue(TICKER_SOURCE_DIR)) {
        if (mistake.expected().passes()) continue;
        ++mistakes;
        if (page.find("\n| " + mistake.name + " | ") != std::string::npos) continue;
        ++missed;
        missing += " " + mistake.name;
    }
    EXPECT_LT(missed * 20, mistakes)
        << "./tick coverage --write docs/public-tests.md adds" << missing;
    EXPECT_GT(mistakes, 150);
}

}  // namespace
}  // namespace ticker
