#include <grader/lab/selftest/BumpTables.h>
#include <grader/tests/support/SlowRun.h>

#include <gtest/gtest.h>

namespace ticker::selftest {
namespace {

// A tenth by `./tick guard slow`.
TEST(BumpSelfTest, APartOfTheTablesComesOutRight) {
    const BumpSelfTest result = runBumpSelfTest(tests::isSlowRun() ? 0.1 : 0.008, {1, 2, 3});
    EXPECT_TRUE(result.passed()) << result.table();
}

}  // namespace
}  // namespace ticker::selftest
