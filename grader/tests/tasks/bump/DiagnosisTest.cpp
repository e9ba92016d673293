// Diagnoses from an examination's numbers, one number at a time.
#include <grader/tasks/bump/words/Diagnosis.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace ticker::tasks::bump {
namespace {

/// The examination of a right submission.
Examination fine() {
    Examination examination;
    examination.conduct.largestTilt = 0.5;
    examination.conduct.inward.asked = 1000.0;
    examination.ladder.ramps.kind = RampKind::right;
    examination.ladder.ramps.fit = ParametrisationFit{Parametrisation({0.0, 1.0, 0.0}, 0.5, false)};
    examination.ladder.ramps.response = Response{};
    examination.regions = RegionAgreement{};
    examination.slopes = SlopeAgreement{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
    examination.letters = LetterReading{};
    return examination;
}

template <typename Change>
std::optional<WrongReason> reasonAfter(const Change& change) {
    Examination examination = fine();
    change(examination);
    return findWrong(examination);
}

TEST(FindWrong, FindsNothingInARightSubmission) {
    EXPECT_FALSE(findWrong(fine()));
    EXPECT_TRUE(diagnose(fine()).faults.empty());
}

TEST(FindWrong, NamesWhatIsWrongWithTheConduct) {
    EXPECT_EQ(reasonAfter([](Examination& e) { e.conduct.chance = 0.011; }), WrongReason::chance);
    EXPECT_FALSE(reasonAfter([](Examination& e) { e.conduct.chance = 0.009; }));
    EXPECT_EQ(reasonAfter([](Examination& e) { e.mapIgnored = true; }), WrongReason::mapIgnored);
    EXPECT_EQ(reasonAfter([](Examination& e) { e.conduct.inward.count = 501.0; }),
              WrongReason::inward);
    EXPECT_EQ(reasonAfter([](Examination& e) { e.conduct.inward.count = 11.0; }),
              WrongReason::inward);
    EXPECT_FALSE(reasonAfter([](Examination& e) { e.conduct.inward.count = 9.0; }));
    const auto withFlat = [](double inward) {
        return reasonAfter([=](Examination& e) {
            e.ladder.flatTilt = 0.2;
            e.conduct.inward.count = inward;
        });
    };
    EXPECT_EQ(withFlat(499.0), WrongReason::flatTilted);
    EXPECT_EQ(withFlat(501.0), WrongReason::inward);
}

TEST(FindWrong, NamesARememberedMapWhereRampsTiltNothing) {
    const auto ofKind = [](RampKind kind) {
        return reasonAfter([=](Examination& e) {
            e.ladder.ramps.kind = kind;
            e.conduct.sameOnOtherMap = true;
        });
    };
    EXPECT_EQ(ofKind(RampKind::silent), WrongReason::mapIgnored);
    EXPECT_FALSE(ofKind(RampKind::right));
}

TEST(FindWrong, NamesSteepSlopesThatTurnTheNormalPastTheHorizon) {
    EXPECT_EQ(reasonAfter([](Examination& e) { e.proportion.pastHorizon = 0.031; }),
              WrongReason::pastHorizon);
    EXPECT_FALSE(reasonAfter([](Examination& e) { e.proportion.pastHorizon = 0.029; }));
}

TEST(FindWrong, NamesSlopesThatCountByTheirHeight) {
    const auto withRatio = [](double ratio) {
        return reasonAfter([=](Examination& e) { e.proportion.brightOverDark = ratio; });
    };
    EXPECT_EQ(withRatio(2.6), WrongReason::heightsBent);
    EXPECT_EQ(withRatio(1.0 / 6.3), WrongReason::heightsBent);
    EXPECT_FALSE(withRatio(2.4));
    EXPECT_FALSE(withRatio(1.0 / 6.1));
}

TEST(FindWrong, NamesWhatIsWrongWithTheRamps) {
    EXPECT_EQ(reasonAfter([](Examination& e) { e.ladder.flatTilt = 0.11; }),
              WrongReason::flatTilted);
    EXPECT_FALSE(reasonAfter([](Examination& e) { e.ladder.flatTilt = 0.09; }));
    const auto ofKind = [](RampKind kind, bool grows = true) {
        return reasonAfter([=](Examination& e) {
            e.ladder.ramps.kind = kind;
            e.ladder.growsWithSlope = grows;
        });
    };
    EXPECT_EQ(ofKind(RampKind::silent), WrongReason::smallSlopesLost);
    EXPECT_EQ(ofKind(RampKind::slopeUIgnored), WrongReason::slopeUIgnored);
    EXPECT_EQ(ofKind(RampKind::slopeVIgnored), WrongReason::slopeVIgnored);
    EXPECT_EQ(ofKind(RampKind::signLost), WrongReason::signLost);
    EXPECT_EQ(ofKind(RampKind::strangeParametrisation), WrongReason::strangeParametrisation);
    EXPECT_EQ(ofKind(RampKind::strangeParametrisation, false), WrongReason::doesNotGrow);
    EXPECT_EQ(ofKind(RampKind::patchy, false), WrongReason::patchy);
    EXPECT_EQ(ofKind(RampKind::strangeDirection), WrongReason::strangeDirection);
    EXPECT_EQ(ofKind(RampKind::right, false), WrongReason::doesNotGrow);
    EXPECT_FALSE(ofKind(RampKind::inverted, false)) << "has a name";
    EXPECT_FALSE(ofKind(RampKind::swapped, false));
}

TEST(FindWrong, NamesTheMapThatDisagrees) {
    EXPECT_EQ(reasonAfter([](Examination& e) { e.ladder.steepAgrees = 0.94; }),
              WrongReason::steepDiffers);
    EXPECT_FALSE(reasonAfter([](Examination& e) { e.ladder.steepAgrees = 0.96; }));
    EXPECT_EQ(reasonAfter([](Examination& e) { e.slopes->fieldV = 0.89; }),
              WrongReason::slopesDiffer);
    EXPECT_EQ(reasonAfter([](Examination& e) { e.slopes.reset(); }), WrongReason::slopesDiffer);
    EXPECT_EQ(reasonAfter([](Examination& e) { e.slopes->smallU = 0.89; }),
              WrongReason::smallSphereDiffers);
    EXPECT_EQ(reasonAfter([](Examination& e) { e.sharpSteps.turned = 0.11; }),
              WrongReason::sharpStepsTurned);
    EXPECT_EQ(reasonAfter([](Examination& e) { e.regions->u.asOnRamps = 0.74; }),
              WrongReason::regionsDiffer);
    const auto local = [](double best, double slope) {
        return reasonAfter([=](Examination& e) {
            e.regions->v.worst = 0.3;
            e.regions->v.best = best;
            e.slopes->sawtoothU = slope;
        });
    };
    EXPECT_EQ(local(0.81, 0.5), WrongReason::regionsDiffer) << "which rows and columns";
    EXPECT_EQ(local(0.79, 0.5), WrongReason::slopesDiffer);
    EXPECT_EQ(local(0.79, 0.7), WrongReason::regionsDiffer);
    for (const RampKind kind : {RampKind::inverted, RampKind::invertedU, RampKind::invertedV})
        EXPECT_EQ(reasonAfter([=](Examination& e) {
                      e.ladder.ramps.kind = kind;
                      e.slopes.reset();
                  }),
                  WrongReason::slopesDiffer);
    EXPECT_FALSE(reasonAfter([](Examination& e) {
        e.ladder.ramps.kind = RampKind::longitudeDependent;
        e.slopes.reset();
    }));
    const auto withFineness = [](const Fineness& fineness, double balance = 0.0) {
        return reasonAfter([=](Examination& e) {
            e.fineness = fineness;
            e.balance = StepBalance{balance, balance};
        });
    };
    EXPECT_EQ(withFineness({-0.01, 1.0}), WrongReason::coordinatesRounded);
    EXPECT_EQ(withFineness({1.0, -0.01}), WrongReason::coordinatesRounded);
    EXPECT_FALSE(withFineness({0.01, 0.01}));
    EXPECT_EQ(withFineness({-0.01, 1.0}, -0.9), WrongReason::stepsLost);
    EXPECT_EQ(reasonAfter([](Examination& e) { e.letters.reset(); }), WrongReason::lettersDiffer);
    EXPECT_EQ(reasonAfter([](Examination& e) {
                  e.letters->l.alongV = {8, 1, 0};
              }),
              WrongReason::lettersDiffer);
    EXPECT_FALSE(reasonAfter([](Examination& e) { e.letters->l.alongV = {9, 1, 0}; }));
}

using Ids = std::vector<std::string>;
Ids idsAfter(const std::function<void(Examination&)>& change,
             const std::optional<Hints>& hints = {}) {
    Examination examination = fine();
    change(examination);
    Ids ids;
    for (const Fault fault : diagnose(examination, hints).faults)
        ids.emplace_back(textOf(fault).id);
    return ids;
}

TEST(Diagnose, ListsWhatIsVisible) {
    EXPECT_EQ(idsAfter([](Examination& e) { e.conduct.largestTilt = 0.9e-3; }), Ids{"bump.flat"});
    EXPECT_EQ(idsAfter([](Examination& e) { e.conduct.largestTilt = 1.1e-3; }), Ids{});
    EXPECT_EQ(idsAfter([](Examination& e) {
                  e.conduct.largestTilt = 0.0;
                  e.conduct.threw.count = 1.0;
              }),
              Ids{"run.crashed"});
    EXPECT_EQ(idsAfter([](Examination& e) {
                  e.conduct.largestTilt = 0.0;
                  e.conduct.notFinite.count = 1.0;
                  e.mapIgnored = true;  // may be a consequence of missing answers
              }),
              Ids{"bump.not-finite"});
    EXPECT_EQ(idsAfter([](Examination& e) {
                  e.conduct.largestTilt = 0.0;
                  e.conduct.inward.count = 600.0;
              }),
              Ids{"bump.wrong"});
    const auto invertedAndInward = [](double inward) {
        return idsAfter([=](Examination& e) {
            e.conduct.inward.count = inward;
            e.ladder.ramps.kind = RampKind::invertedU;
        });
    };
    EXPECT_EQ(invertedAndInward(901.0), (Ids{"bump.wrong", "bump.inverted-u"}));
    EXPECT_EQ(invertedAndInward(899.0), (Ids{"bump.inverted-u", "bump.wrong"}));
    EXPECT_EQ(idsAfter([](Examination& e) {
                  e.conduct.notUnit.count = 1.0;
                  e.ladder.ramps.kind = RampKind::invertedU;
              }),
              (Ids{"bump.not-unit", "bump.inverted-u"}));
}

TEST(Diagnose, NamesASignOnlyWhereEveryMapAgrees) {
    const std::pair<RampKind, const char*> kinds[] = {{RampKind::inverted, "bump.inverted"},
                                                      {RampKind::invertedU, "bump.inverted-u"},
                                                      {RampKind::invertedV, "bump.inverted-v"}};
    for (const auto& [kind, id] : kinds) {
        const RampKind own = kind;
        EXPECT_EQ(idsAfter([=](Examination& e) { e.ladder.ramps.kind = own; }), Ids{id});
        EXPECT_EQ(idsAfter([=](Examination& e) {
                      e.ladder.ramps.kind = own;
                      e.slopes->fieldU = 0.0;
                  }),
                  Ids{"bump.wrong"});
        EXPECT_EQ(idsAfter([=](Examination& e) {
                      e.ladder.ramps.kind = own;
                      e.ladder.flatTilt = 0.2;
                  }),
                  Ids{"bump.wrong"});
    }
}

TEST(Diagnose, KnowsTransposedAndUpsideDownMaps) {
    const auto transposed = [](bool response, bool here, bool square) {
        Hints hints;
        hints.square.transposed = square;
        return idsAfter(
            [=](Examination& e) {
                if (!response) e.ladder.ramps.response.reset();
                e.ladder.ramps.transposed = here;
                e.regions.reset();
            },
            hints);
    };
    EXPECT_EQ(transposed(false, true, false), Ids{"bump.swapped-axes"});
    EXPECT_EQ(transposed(false, false, true), Ids{"bump.swapped-axes"});
    EXPECT_EQ(transposed(false, false, false), Ids{"bump.wrong"});
    EXPECT_EQ(transposed(true, true, true), Ids{"bump.wrong"});
    const auto towards = [](double y, double flatTilt) {
        return idsAfter([=](Examination& e) {
            e.ladder.ramps.fit =
                ParametrisationFit{Parametrisation({std::sqrt(1.0 - y * y), y, 0.0}, 0.5, false)};
            e.ladder.flatTilt = flatTilt;
        });
    };
    EXPECT_EQ(towards(-0.71, 0.0), Ids{"bump.upside-down"});
    EXPECT_EQ(towards(-0.69, 0.0), Ids{});
    EXPECT_EQ(towards(-1.0, 0.2), Ids{"bump.wrong"});
}

}  // namespace
}  // namespace ticker::tasks::bump
