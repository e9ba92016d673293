// The limits within which an agreement, letters or a fit count as good.
#include <grader/tasks/bump/answers/Letters.h>
#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/questions/Regions.h>
#include <grader/tasks/bump/questions/Slopes.h>

#include <gtest/gtest.h>

namespace ticker::tasks::bump {
namespace {

TEST(Agreement, HoldsUpToItsLimits) {
    SlopeAgreement slopes{0.61, 0.61, 0.91, 0.91};
    EXPECT_TRUE(slopes.good());
    for (double SlopeAgreement::*part : {&SlopeAgreement::sawtoothU, &SlopeAgreement::sawtoothV}) {
        SlopeAgreement less = slopes;
        less.*part = 0.59;
        EXPECT_FALSE(less.good());
    }
    for (double SlopeAgreement::*part : {&SlopeAgreement::fieldU, &SlopeAgreement::fieldV}) {
        SlopeAgreement less = slopes;
        less.*part = 0.89;
        EXPECT_FALSE(less.good());
    }
    RegionShares regions;
    regions.asOnRamps = 0.76;
    regions.worst = 0.41;
    regions.best = 0.9;
    EXPECT_TRUE(regions.good());
    EXPECT_FALSE(regions.isLocal());
    regions.worst = 0.39;
    EXPECT_FALSE(regions.good());
    EXPECT_TRUE(regions.isLocal());
    EXPECT_TRUE((RegionAgreement{regions, {}, 0, 0}.isLocal()));
    EXPECT_FALSE((RegionAgreement{{}, regions, 0, 0}.good()));
    EXPECT_FALSE((RegionAgreement{regions, {}, 0, 0}.good()));
}

TEST(Letters, AreReadByTheirEdges) {
    const EdgeCount right{50, 5, 45};
    EXPECT_TRUE(right.mostlyRight());
    EXPECT_FALSE((EdgeCount{50, 6, 44}.mostlyRight()));
    EXPECT_FALSE((EdgeCount{50, 5, 46}.mostlyRight()));
    EXPECT_FALSE((EdgeCount{0, 0, 0}.mostlyRight()));
    const EdgeCount opposite{5, 50, 45};
    EXPECT_TRUE(opposite.mostlyOpposite());
    EXPECT_FALSE((EdgeCount{6, 50, 44}.mostlyOpposite()));
    EXPECT_FALSE((EdgeCount{5, 50, 46}.mostlyOpposite()));
    EXPECT_FALSE((EdgeCount{0, 0, 0}.mostlyOpposite()));
    EXPECT_EQ(right.crossed(), 100);
    EXPECT_EQ(look({right, right}, false), "raised");
    EXPECT_EQ(look({right, right}, true), "lowered");
    EXPECT_EQ(look({opposite, opposite}, false), "lowered");
    EXPECT_EQ(look({opposite, opposite}, true), "raised");
    EXPECT_EQ(look({right, opposite}, false), "half");
    EXPECT_EQ(look({opposite, right}, false), "half");
    EXPECT_EQ(look({right, {}}, false), "unclear");
    EXPECT_EQ(look({{}, opposite}, false), "unclear");
    EXPECT_EQ(look({right, {10, 10, 0}}, false), "unclear");
}

TEST(ParametrisationFit, IsGoodUpToItsLimits) {
    const ParametrisationFit fit{Parametrisation({0.0, 1.0, 0.0}, 0.5, false), 1.05, 0.019, 0.019,
                                 0.029};
    EXPECT_TRUE(fit.good());
    const auto after = [&](double ParametrisationFit::*part, double value) {
        ParametrisationFit changed = fit;
        changed.*part = value;
        return changed.good();
    };
    EXPECT_TRUE(after(&ParametrisationFit::axisLength, 0.95));
    EXPECT_FALSE(after(&ParametrisationFit::axisLength, 1.07));
    EXPECT_FALSE(after(&ParametrisationFit::axisLength, 0.93));
    EXPECT_FALSE(after(&ParametrisationFit::medianUError, 0.021));
    EXPECT_FALSE(after(&ParametrisationFit::medianVError, 0.021));
    EXPECT_FALSE(after(&ParametrisationFit::strayShare, 0.031));
}

TEST(IsOrdinary, EndsBeforePolesAndSeam) {
    const Parametrisation parametrisation({0.0, 1.0, 0.0}, 0.5, false);
    const auto at = [&](double u, double v) {
        return isOrdinary(parametrisation, parametrisation.direction(u, v));
    };
    EXPECT_TRUE(at(0.3, 0.061));
    EXPECT_FALSE(at(0.3, 0.059));
    EXPECT_TRUE(at(0.3, 0.939));
    EXPECT_FALSE(at(0.3, 0.941));
    EXPECT_TRUE(at(0.021, 0.5));
    EXPECT_FALSE(at(0.019, 0.5));
    EXPECT_TRUE(at(0.979, 0.5));
    EXPECT_FALSE(at(0.981, 0.5));
}

}  // namespace
}  // namespace ticker::tasks::bump
