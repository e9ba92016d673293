#include <grader/build/Kit.h>
#include <grader/lab/agreement/OracleAgreement.h>
#include <grader/sandbox/Sandbox.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <utility>

namespace ticker::calibrate {
namespace {

const std::filesystem::path kSource = TICKER_SOURCE_DIR;

/// A part of the campaign of `./tick calibrate`, with some of its readings.
class OracleReadings : public testing::Test {
protected:
    template <typename Predicate>
    [[nodiscard]] OracleAgreement campaignOf(const Predicate& wanted) const {
        AgreementPlan plan;
        plan.scenes = kSource / "scenes";
        plan.assets = kSource / "assets";
        plan.reference = kSource / "reference_solution/exercise";
        for (AgreementCase& one : agreementCases(corpus::readCatalogue(kSource)))
            if (wanted(one)) plan.cases.push_back(std::move(one));
        return {std::move(plan), kit_, sandbox_};
    }

    static Summary runAll(OracleAgreement& campaign) {
        std::vector<std::string> records;
        for (std::size_t unit = 0; unit < campaign.units(); ++unit)
            records.push_back(campaign.run(unit));
        return campaign.summarise(records);
    }

private:
    build::Kit kit_ = build::Kit::besideProgram();
    sandbox::Sandbox sandbox_ = sandbox::Sandbox::best();
};

// Seeds are fixed: a test that passes once passes always. Some 700 comparisons, each with a
// false-alarm probability below 1e-8.
TEST_F(OracleReadings, AgreeWithTheReferenceSolutionOnEveryScene) {
    OracleAgreement campaign =
        campaignOf([](const AgreementCase& one) { return one.name == "reference"; });
    EXPECT_GE(campaign.units(), 8U);
    const Summary summary = runAll(campaign);
    EXPECT_TRUE(summary.asExpected) << summary.text;
}

TEST_F(OracleReadings, OfTheBumpMapAgreePixelByPixel) {
    OracleAgreement campaign =
        campaignOf([](const AgreementCase& one) { return one.file == "BumpySphere.cpp"; });
    EXPECT_GE(campaign.units(), 18U);
    const Summary summary = runAll(campaign);
    EXPECT_TRUE(summary.asExpected) << summary.text;
}

// A scene that distinguishes the readings: otherwise agreement would prove nothing.
TEST_F(OracleReadings, ThatAreToldWronglyDoNotAgree) {
    const std::map<std::string, std::string> shownBy{{"half-aperture", "lens-grid"},
                                                     {"surface", "distributed"},
                                                     {"bump-mirrored", "bumpmap-test"}};
    OracleAgreement campaign = campaignOf([&](AgreementCase& one) {
        one.reading = {};
        return shownBy.contains(one.name);
    });
    int shown = 0;
    for (std::size_t unit = 0; unit < campaign.units(); ++unit) {
        const auto [reading, scene] = campaign.nameOf(unit);
        if (shownBy.at(reading) != scene) continue;
        ++shown;
        EXPECT_FALSE(campaign.summarise({campaign.run(unit)}).asExpected) << reading;
    }
    EXPECT_EQ(shown, 3);
}

}  // namespace
}  // namespace ticker::calibrate
