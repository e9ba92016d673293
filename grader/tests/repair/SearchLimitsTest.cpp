#include <grader/repair/SearchLimits.h>

#include <grader/base/WholeFile.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace ticker::repair {
namespace {

std::string complaint(const std::string& text) {
    try {
        static_cast<void>(parseSearchLimits(text, "limits.json"));
    } catch (const raytracer::InputError& error) {
        return error.what();
    }
    return "none";
}

std::string text(const std::string& wall, const std::string& twins) {
    return R"({"cpuSeconds": 10, "wallSeconds": )" + wall +
           R"(, "untilShare": {"others": 0.1, "singles": 0.4, "formulas": 0.5, "wide": 0.6, "twins": )" +
           twins + R"(, "pairs": 0.8, "twoMistakes": 1.0}})";
}

TEST(SearchLimits, AreTheFileThatTheProgramWasBuiltWith) {
    const std::filesystem::path file =
        std::filesystem::path{TICKER_SOURCE_DIR} / "grader/repair/limits.json";
    const SearchLimits read = parseSearchLimits(readWhole(file), file.string());
    EXPECT_EQ(read.all.cpuSeconds, defaultSearchLimits().all.cpuSeconds);
    EXPECT_EQ(read.pairs, defaultSearchLimits().pairs);
}

TEST(SearchLimits, SharesGrowFromKindToKind) {
    EXPECT_EQ(complaint(text("60", "0.7")), "none");
    EXPECT_NE(complaint(text("60", "0.5")).find("no smaller than the one before"),
              std::string::npos);
}

TEST(SearchLimits, TheWallHasAtLeastTheTimeOfTheCpu) {
    EXPECT_NE(complaint(text("9", "0.7")).find("wallSeconds"), std::string::npos);
}

}  // namespace
}  // namespace ticker::repair
