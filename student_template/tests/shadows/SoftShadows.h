#ifndef SHADOWS_SOFTSHADOWS_H
#define SHADOWS_SOFTSHADOWS_H

#include <raytracer/base/RenderSettings.h>
#include <raytracer/image/ColourRGB.h>
#include <raytracer/math/Ray.h>
#include <raytracer/math/Vector3.h>
#include <raytracer/scene/Scene.h>
#include <raytracer/scene/SceneDescription.h>
#include <support/RayLog.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace raytracer::tests::shadows {

/// "(0.1, 0.2, 0.3)"
[[nodiscard]] std::string words(const ColourRGB& c);

/// Whether no channel differs by more than a share of the larger value.
[[nodiscard]] bool isNear(const ColourRGB& a, const ColourRGB& b, double share);

/// Why a test is skipped.
inline const std::string kUnseen = "your code casts rays that the test cannot see";

/// Repeated calls of one solution at one point of a scene.
class Trial {
public:
    /// @param object  Index of the object with the point; -1: the last one.
    Trial(const SceneDescription& description, const Vector3& point, int calls, int object = -1);

    [[nodiscard]] const std::vector<ColourRGB>& colours() const { return colours_; }
    [[nodiscard]] const ColourRGB& mean() const { return mean_; }
    /// All logged rays, as cast from the point.
    [[nodiscard]] const std::vector<Ray>& rays() const { return rays_; }
    /// The smallest number of rays of one call.
    [[nodiscard]] std::size_t fewestRays() const { return fewestRays_; }

private:
    RayLog log_;
    std::vector<ColourRGB> colours_;
    ColourRGB mean_;
    std::vector<Ray> rays_;
    std::size_t fewestRays_ = std::numeric_limits<std::size_t>::max();
};

/// Task T2.1, Renderer::illuminate: shared parts of its public tests.
class SoftShadows : public ::testing::Test {
protected:
    /// Skips a task that is not attempted.
    void SetUp() override;

    /// Whether the log lacks shadow rays: it has none, or only rays to the light's centre although
    /// the colours at the edge of a shadow differ from call to call.
    [[nodiscard]] static bool lacksRays(const Trial& trial);

    const RenderSettings handout_{};
};

}  // namespace raytracer::tests::shadows

#endif
