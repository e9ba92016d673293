#include <grader/selftest/BumpTables.h>

#include <gtest/gtest.h>

#include <cstdlib>

namespace ticker::selftest {
namespace {

TEST(BumpSelfTest, ATenthOfTheTablesComesOutRight) {
    const char* fraction = std::getenv("BUMP_FRACTION");
    const BumpSelfTest result = runBumpSelfTest(fraction ? std::atof(fraction) : 0.1, {1, 2, 3});
    EXPECT_TRUE(result.passed()) << result.table();
}

}  // namespace
}  // namespace ticker::selftest
