#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/support/FindingOrder.h>

#include <gtest/gtest.h>

#include <string>
#include <variant>

namespace ticker::tasks {
namespace {

Finding failing(const FindingText& text) {
    return distributedFinding(text, Severity::fail, "seen");
}
Finding warning(const FindingText& text) {
    return distributedFinding(text, Severity::warn, "seen");
}

std::string idsOf(const std::vector<Finding>& findings) {
    std::string ids;
    for (const Finding& finding : findings)
        ids += finding.id + " ";
    return ids;
}

TEST(DistributedFinding, HasHintAndSectionOfItsId) {
    const Finding finding = failing(kDofNone);
    EXPECT_EQ(finding.message, "seen");
    EXPECT_NE(finding.hint.find("random point of the aperture"), std::string::npos);
    EXPECT_NE(finding.section.find("T2.2"), std::string::npos);
    EXPECT_NE(failing(kShadowHard).section.find("T2.1"), std::string::npos);
    EXPECT_TRUE(failing(kShadowUnseenRays).hint.empty()) << "the message says it";
}

TEST(MostImportantFirst, KeepsOneFailureAndEveryWarning) {
    const std::vector<Finding> kept = mostImportantFirst(
        {warning(kShadowFixedSamples), failing(kShadowWrong), failing(kShadowInverted),
         failing(kShadowWrong), warning(kShadowClustered)},
        kShadowFindings);
    EXPECT_EQ(idsOf(kept), "shadow.inverted shadow.fixed-samples shadow.clustered ");
    ASSERT_EQ(kept[0].evidence.size(), 1U);
    EXPECT_EQ(std::get<std::string>(kept[0].evidence[0].second), "shadow.wrong") << "once";
    const std::vector<Finding> others = mostImportantFirst(
        {failing(kDofWrong), failing(kDofDisc), failing(kDofNone)}, kLensFindings);
    EXPECT_EQ(std::get<std::string>(others.at(0).evidence.at(0).second), "dof.disc, dof.wrong");
}

TEST(MostImportantFirst, KeepsAllWarningsWhereNothingFails) {
    EXPECT_EQ(idsOf(mostImportantFirst({warning(kShadowClustered), warning(kShadowHard)},
                                       kShadowFindings)),
              "shadow.hard shadow.clustered ");
    EXPECT_TRUE(mostImportantFirst({}, kShadowFindings).empty());
}

}  // namespace
}  // namespace ticker::tasks
