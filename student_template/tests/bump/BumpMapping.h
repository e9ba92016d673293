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

/// A rise over the whole map that is small enough to saturate nothing.
inline constexpr Slope kGentle{0.3, 0};
/// A slope that is visible to code that rounds heights to bytes.
inline constexpr Slope kCoarse{0.0, 12};

/// "(0.1, 0.2, 0.3)"
[[nodiscard]] std::string words(const Vector3& v);

/// Random heights: a mistake anywhere in the code shows on such a map.
[[nodiscard]] HeightMap roughMap(int width, int height);

/// Ordinary points, and points where an angle or a coordinate is exactly 0.
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

    /// Without a survey the first test complains, and the others cannot be asked.
    static bool couldSurvey();

private:
    static void missTheSurvey();
};

}  // namespace raytracer::tests::bump

#endif
