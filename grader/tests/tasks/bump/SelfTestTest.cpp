#include <grader/lab/selftest/BumpTables.h>
#include <grader/tests/support/SlowRun.h>

#include <gtest/gtest.h>

namespace ticker::selftest {
namespace {

// `./tick guard slow` runs a tenth of the tables.
TEST(BumpSelfTest, APartOfTheTablesComesOutRight) {
    const BumpSelfTest result = runBumpSelfTest(tests::isSlowRun() ? 0.1 : 0.008, {1, 2, 3});
    EXPECT_TRUE(result.passed()) << result.table();
}

}  // namespace
}  // namespace ticker::selftest
