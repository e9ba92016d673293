#include <grader/tasks/support/FindingText.h>

#include <gtest/gtest.h>

#include <string>
#include <variant>

namespace ticker::tasks {
namespace {

Finding failing(const char* id) {
    return distributedFinding(id, Severity::fail, "seen");
}
Finding warning(const char* id) {
    return distributedFinding(id, Severity::warn, "seen");
}

std::string idsOf(const std::vector<Finding>& findings) {
    std::string ids;
    for (const Finding& finding : findings)
        ids += finding.id + " ";
    return ids;
}

TEST(DistributedFinding, HasHintAndSectionOfItsId) {
    const Finding finding = failing("dof.none");
    EXPECT_EQ(finding.message, "seen");
    EXPECT_NE(finding.hint.find("random point of the aperture"), std::string::npos);
    EXPECT_NE(finding.section.find("T2.2"), std::string::npos);
    EXPECT_NE(failing("shadow.hard").section.find("T2.1"), std::string::npos);
    EXPECT_TRUE(failing("shadow.unseen-rays").hint.empty()) << "known to nobody";
}

TEST(MostImportantFirst, KeepsOneFailureAndEveryWarning) {
    const std::vector<Finding> kept = mostImportantFirst(
        {warning("shadow.fixed-samples"), failing("shadow.wrong"), failing("shadow.inverted"),
         failing("shadow.wrong"), warning("shadow.clustered")});
    EXPECT_EQ(idsOf(kept), "shadow.inverted shadow.fixed-samples shadow.clustered ");
    ASSERT_EQ(kept[0].evidence.size(), 1U);
    EXPECT_EQ(std::get<std::string>(kept[0].evidence[0].second), "shadow.wrong") << "once";
    const std::vector<Finding> others =
        mostImportantFirst({failing("dof.wrong"), failing("dof.disc"), failing("dof.none")});
    EXPECT_EQ(std::get<std::string>(others.at(0).evidence.at(0).second), "dof.disc, dof.wrong");
}

TEST(MostImportantFirst, KeepsAllWarningsWhereNothingFails) {
    EXPECT_EQ(idsOf(mostImportantFirst({warning("shadow.clustered"), warning("shadow.hard")})),
              "shadow.hard shadow.clustered ");
    EXPECT_TRUE(mostImportantFirst({}).empty());
}

}  // namespace
}  // namespace ticker::tasks
