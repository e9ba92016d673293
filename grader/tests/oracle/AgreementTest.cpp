#include <grader/lab/agreement/MomentAgreement.h>
#include <grader/oracle/Oracle.h>
#include <grader/tests/oracle/PlainRenderer.h>
#include <grader/tests/oracle/TestScenes.h>

#include <raytracer/render/Renderer.h>

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

namespace ticker::oracle::test {
namespace {

using raytracer::RenderSettings;

// Every test below looks at 36 tile means (|z| of a normal variable) and one variance: all tests
// together make fewer than 2500 comparisons, each with a false-alarm probability below 4e-8 at 5.5.
// Seeds are fixed, so that a test that passes once passes always.
constexpr double kLargestZ = 5.5;
constexpr int kRenders = 20;

RenderSettings smallSettings() {
    RenderSettings settings;
    settings.width = 24;
    settings.height = 18;
    settings.dofRayCount = 16;
    settings.shadowRayCount = 5;
    settings.dofFocalPlane = 4.0;
    return settings;
}

Precision fine() {
    Precision precision;
    precision.share = 0.05;
    precision.renders = kRenders;
    return precision;
}

void expectAgreement(const calibrate::Agreement& agreement) {
    EXPECT_LT(agreement.largestZ, kLargestZ);
    EXPECT_LT(agreement.varianceZ, kLargestZ) << "variance ratio " << agreement.varianceRatio;
}

void expectReferenceAgrees(const raytracer::SceneDescription& description,
                           const RenderSettings& settings, int renders) {
    const Moments moments = Oracle{description, settings}.moments(11, fine());
    const raytracer::Scene scene{description};
    expectAgreement(calibrate::compare(moments, renders, [&](int number) {
        RenderSettings own = settings;
        own.seed = static_cast<std::uint64_t>(number);
        return raytracer::Renderer{own}.render(scene);
    }));
}

TEST(OracleMoments, AgreeWithTheReferenceSolutionOnTheHandoutsScene) {
    RenderSettings settings;
    settings.width = 24;
    settings.height = 18;
    expectReferenceAgrees(distributedScene(), settings, 60);
}

TEST(OracleMoments, AgreeWithTheReferenceSolutionOnAVariedScene) {
    expectReferenceAgrees(variedScene(), smallSettings(), 80);
}

TEST(OracleMoments, AgreeWithTheReferenceSolutionInARegion) {
    RenderSettings settings = smallSettings();
    settings.width = 96;
    settings.height = 72;
    settings.region = {30, 20, 24, 18};
    expectReferenceAgrees(variedScene(), settings, 40);
}

TEST(OracleMoments, AgreeWithTheReferenceSolutionAfterTwoSmallMirrors) {
    RenderSettings settings = smallSettings();
    settings.dofAmount = 0.1;
    settings.dofFocalPlane = 3.518;
    settings.region = {4, 12, 1, 1};
    expectReferenceAgrees(smallMirrorsScene(), settings, 100);
}

TEST(OracleMoments, AgreeWithTheOraclesOwnStudents) {
    const Oracle oracle{variedScene(), smallSettings()};
    const Moments moments = oracle.moments(12, fine());
    // Two hundred renders, so that a bias of the finite pool of aim points would show.
    expectAgreement(calibrate::compare(moments, 200, [&](int number) {
        return oracle.studentRender(static_cast<std::uint64_t>(number));
    }));
}

struct Case {
    std::string name;
    Reading reading;
    Mistake mistake;
};

void PrintTo(const Case& value, std::ostream* stream) {
    *stream << value.name;
}

class EveryReading : public testing::TestWithParam<Case> {};

TEST_P(EveryReading, AgreesWithAPlainRenderer) {
    const Case& param = GetParam();
    const RenderSettings settings = smallSettings();
    const raytracer::SceneDescription description = variedScene();
    const Oracle oracle{description, settings, param.reading, param.mistake};
    const Moments moments = oracle.moments(13, fine());
    const raytracer::Scene scene{description};
    expectAgreement(calibrate::compare(moments, kRenders, [&](int number) {
        return PlainRenderer{scene, settings, param.reading, param.mistake,
                             static_cast<std::uint64_t>(number)}
            .render();
    }));
    expectAgreement(calibrate::compare(moments, kRenders, [&](int number) {
        return oracle.studentRender(static_cast<std::uint64_t>(number));
    }));
}

template <typename Change>
Case changed(const char* name, const Change& change) {
    Case result{name, {}, {}};
    change(result.reading, result.mistake);
    return result;
}

std::vector<Case> cases() {
    using R = Reading&;
    using M = Mistake&;
    return {
        changed("HalfAperture", [](R r, M) { r.apertureFactor = 0.5; }),
        changed("Antialiased",
                [](R r, M) {
                    r.pixelSpread = 1.0;
                    r.phong = PhongReading::perSample;
                }),
        changed("AntialiasedInside", [](R r, M) { r.pixelSpread = 0.5; }),
        changed("Surface", [](R r, M) { r.lightShape = LightShape::surface; }),
        changed("UniformRadius", [](R r, M) { r.lightShape = LightShape::uniformRadius; }),
        changed("PolarHelper", [](R r, M) { r.lightShape = LightShape::polarHelper; }),
        changed("ToCentre", [](R r, M) { r.shadowReach = ShadowReach::toCentre; }),
        changed("PerSample", [](R r, M) { r.phong = PhongReading::perSample; }),
        changed("PerDirection", [](R r, M) { r.phong = PhongReading::perSampleDirection; }),
        changed("ViewerIsEye", [](R r, M) { r.viewerIsEye = true; }),
        changed("BiasAlongLight",
                [](R r, M) {
                    r.biasAlongLight = true;
                    r.shadowBias = 1e-3;
                }),
        changed("Cube", [](R r, M) { r.lightShape = LightShape::cube; }),
        changed("Hard", [](R r, M) { r.lightShape = LightShape::centre; }),
        changed("Endless", [](R r, M) { r.shadowReach = ShadowReach::endless; }),
        changed("LightSize", [](R, M m) { m.lightSizeFactor = 1.5; }),
        changed("OffCentreHalfBall",
                [](R r, M m) {
                    r.lightShape = LightShape::halfBall;
                    m.lightOffset[0] = 0.5;
                }),
        changed("LightDiscOnLensDisc",
                [](R r, M m) {
                    r.lightShape = LightShape::disc;
                    m.aperture = Mistake::Aperture::disc;
                }),
        changed("AllOrNothing", [](R, M m) { m.allOrNothing = true; }),
        changed("LitIfAny", [](R, M m) { m.litIfAny = true; }),
        changed("InvertedAndMixed",
                [](R, M m) {
                    m.shadowInverted = true;
                    m.lightsMixed = true;
                }),
        changed("AmbientScaled", [](R, M m) { m.ambientScaled = true; }),
        changed("SpecularUnshadowed", [](R, M m) { m.specularUnshadowed = true; }),
        changed("DiffuseUnshadowed", [](R, M m) { m.diffuseUnshadowed = true; }),
        changed("PointJitter", [](R, M m) { m.pointJitter = 0.1; }),
        changed("DirectionOffset",
                [](R, M m) {
                    m.directionOffset = true;
                    m.lightSizeFactor = 0.3;
                }),
        changed("OffCentreLens",
                [](R, M m) {
                    m.lensOffsetX = 1.0;
                    m.aperture = Mistake::Aperture::diagonal;
                }),
        changed("FocusByDistance",
                [](R, M m) {
                    m.focalByDistance = true;
                    m.aperture = Mistake::Aperture::horizontal;
                }),
        changed("OtherFocusAndSum",
                [](R, M m) {
                    m.focalFactor = 1.2;
                    m.pixelScale = 20.0;
                }),
    };
}

INSTANTIATE_TEST_SUITE_P(Oracle, EveryReading, testing::ValuesIn(cases()),
                         [](const auto& chosen) { return chosen.param.name; });

}  // namespace
}  // namespace ticker::oracle::test
