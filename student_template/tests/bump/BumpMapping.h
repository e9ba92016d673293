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

/// So little that nothing saturates, for all of a map.
inline constexpr Slope kGentle{0.3, 0};
/// What code that rounds heights to bytes sees of a slope.
inline constexpr Slope kCoarse{0.0, 12};

/// Fails the running test.
void complain(const std::string& asked, const std::string& expected, const std::string& got,
              const std::string& cause, const std::string& section);

/// "(0.1, 0.2, 0.3)"
[[nodiscard]] std::string words(const Vector3& v);

/// Random heights: whatever goes wrong somewhere goes wrong on such a map.
[[nodiscard]] HeightMap roughMap(int width, int height);

/// Ordinary points, and those where an angle or a coordinate is exactly 0.
[[nodiscard]] std::vector<Vector3> telltaleDirections();

/// Task T1, BumpySphere::getNormalAt: what its public tests share.
class BumpMapping : public ::testing::Test {
protected:
    /// Skips what is not attempted.
    void SetUp() override;

    /// What the solution does on gentle slopes, or on those of whole bytes where only these tilt
    /// along both axes. Empty where it throws, which a test of its own says.
    static const std::optional<BumpSurvey>& survey();
    static std::optional<BumpSurvey> surveyOn(const Slope& slope);

    /// Where there is no survey the first test complains, and others could not be asked.
    static bool couldSurvey();

private:
    static void missTheSurvey();
};

}  // namespace raytracer::tests::bump

#endif
