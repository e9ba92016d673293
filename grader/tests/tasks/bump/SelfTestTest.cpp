#include <grader/lab/selftest/BumpTables.h>

#include <gtest/gtest.h>

namespace ticker::selftest {
namespace {

TEST(BumpSelfTest, ATenthOfTheTablesComesOutRight) {
    const BumpSelfTest result = runBumpSelfTest(0.1, {1, 2, 3});
    EXPECT_TRUE(result.passed()) << result.table();
}

}  // namespace
}  // namespace ticker::selftest
