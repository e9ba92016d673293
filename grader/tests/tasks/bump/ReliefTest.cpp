#include <grader/tests/tasks/bump/Judging.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace ticker::tests {
namespace {

using selftest::Mistake;

const EvidenceValue* evidence(const TaskJudgement& judgement, const std::string& key) {
    for (const auto& [name, value] : judgement.findings.front().evidence)
        if (name == key) return &value;
    return nullptr;
}

TEST(BumpRelief, ShowsTheHalfInvertedLettersInWordsAndPictures) {
    const TaskJudgement judgement = judge({}, Mistake::invertedU);
    ASSERT_EQ(firstId(judgement), "bump.inverted-u");
    EXPECT_EQ(std::get<std::string>(*evidence(judgement, "letterH")), "half");
    EXPECT_EQ(std::get<std::string>(*evidence(judgement, "letterL")), "half");
    const std::vector<Raster>& rasters = judgement.findings.front().rasters;
    ASSERT_EQ(rasters.size(), 2U);
    for (const Raster& raster : rasters)
        EXPECT_EQ(raster.values.size(), static_cast<std::size_t>(raster.width * raster.height));
}

/// The correlation of two pictures.
double likeness(const std::vector<float>& a, const std::vector<float>& b) {
    double meanA = 0.0;
    double meanB = 0.0;
    const auto count = static_cast<double>(a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        meanA += a[i] / count, meanB += b[i] / count;
    double aa = 0.0;
    double bb = 0.0;
    double ab = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        aa += (a[i] - meanA) * (a[i] - meanA);
        bb += (b[i] - meanB) * (b[i] - meanB);
        ab += (a[i] - meanA) * (b[i] - meanB);
    }
    return ab / std::sqrt(aa * bb);
}

TEST(BumpRelief, RecoversTheReliefThatTheNormalsShow) {
    // Inverted along both axes, so the picture must be the negative of the true one.
    const TaskJudgement inverted = judge({}, Mistake::inverted);
    const std::vector<Raster>& lowered = inverted.findings.front().rasters;
    EXPECT_LT(likeness(lowered.at(0).values, lowered.at(1).values), -0.9);
    EXPECT_EQ(std::get<std::string>(*evidence(inverted, "letterH")), "lowered");
    EXPECT_EQ(std::get<std::string>(*evidence(inverted, "letterL")), "raised");
    // Upside down, but raised.
    const TaskJudgement turned = judge({}, Mistake::upsideDown);
    const std::vector<Raster>& raised = turned.findings.front().rasters;
    EXPECT_GT(likeness(raised.at(0).values, raised.at(1).values), 0.9);
}

}  // namespace
}  // namespace ticker::tests
