#include <grader/report/ClassPage.h>
#include <grader/report/ReportWords.h>

#include "ExampleResults.h"

#include <gtest/gtest.h>

namespace ticker::report {
namespace {

TEST(Counted, IsOneOfAThingOrManyOfThem) {
    EXPECT_EQ(counted(0, "submission"), "0 submissions");
    EXPECT_EQ(counted(1, "submission"), "1 submission");
    EXPECT_EQ(counted(2, "result"), "2 results");
}

TEST(Counted, IsWhatThePageOfAClassOfOneSays) {
    const std::string page = classPage(exampleClass(1));
    EXPECT_NE(page.find("1 submission<"), std::string::npos);
    EXPECT_EQ(page.find("1 submissions"), std::string::npos);
}

}  // namespace
}  // namespace ticker::report
