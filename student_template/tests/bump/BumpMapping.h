#ifndef BUMP_BUMPMAPPING_H
#define BUMP_BUMPMAPPING_H

#include <bump/BumpSurvey.h>
#include <raytracer/geometry/HeightMap.h>
#include <raytracer/math/Vector3.h>

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace raytracer::tests::bump {

/// A gentle ramp over the whole map. Ramps that rise sixteen times as much (SlopesTest.cpp) still
/// stay below kBumpFactor, where heights are clamped.
inline constexpr Slope kGentle{0.3, 0};
/// A slope in grey levels for each texel, visible to code that rounds heights to bytes.
inline constexpr Slope kCoarse{0.0, 12};

/// "(0.1, 0.2, 0.3)"
[[nodiscard]] std::string words(const Vector3& v);

/// Random heights: a mistake anywhere in the code shows on such a map.
[[nodiscard]] HeightMap roughMap(int width, int height);

/// Directions of random points, and of points where an angle or a coordinate is exactly 0.
[[nodiscard]] std::vector<Vector3> telltaleDirections();

/// Task T1, BumpySphere::getNormalAt: shared parts of its public tests.
class BumpMapping : public ::testing::Test {
protected:
    /// Skips a task that is not attempted.
    void SetUp() override;

    /// The solution's tilts on gentle slopes, or on slopes of whole bytes if only these tilt along
    /// both axes. Empty if the solution throws, which another test reports.
    static const std::optional<BumpSurvey>& survey();
    static std::optional<BumpSurvey> surveyOn(const Slope& slope);

    /// False if the solution throws on the survey's maps. The first test that calls this then
    /// fails, and the others are skipped.
    static bool couldSurvey();

private:
    static void missTheSurvey();
};

}  // namespace raytracer::tests::bump

#endif
