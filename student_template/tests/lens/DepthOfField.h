#ifndef LENS_DEPTHOFFIELD_H
#define LENS_DEPTHOFFIELD_H

#include <raytracer/base/RenderSettings.h>
#include <raytracer/image/ColourRGB.h>
#include <raytracer/math/Ray.h>
#include <raytracer/math/Vector3.h>
#include <raytracer/scene/Scene.h>
#include <raytracer/scene/SceneDescription.h>
#include <support/RayLog.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace raytracer::tests::lens {

constexpr int kRenders = 40;
inline const std::string kUnseen = "your code casts rays that the test cannot see";
inline const std::string kAsked = "a frame of 2 x 1 pixels, rendered 40 times";

/// The point where the ray's line meets the plane with this z.
[[nodiscard]] Vector3 inPlane(const Ray& ray, double z);

/// A wall of one colour, with ambient light only, so that mistakes in `illuminate` do not count
/// against `render`.
[[nodiscard]] SceneDescription wall();

/// Two large balls far behind the focal plane: each pixel's rays see partly the ball in front of
/// them and partly the wall. Left is red, right is green.
[[nodiscard]] SceneDescription twoBalls();

/// Two pixels side by side, rendered many times.
class Trial {
public:
    Trial(const SceneDescription& description, int renders);

    [[nodiscard]] static RenderSettings twoPixels();

    /// Colours of the left pixel (0) or the right one (1), for each render.
    [[nodiscard]] const std::vector<ColourRGB>& colours(std::size_t pixel) const {
        return colours_[pixel];
    }
    /// Camera rays of that pixel in all renders.
    [[nodiscard]] const std::vector<Ray>& rays(std::size_t pixel) const { return rays_[pixel]; }
    /// The smallest number of camera rays that any render cast for one of the pixels.
    [[nodiscard]] std::size_t fewestRays() const { return fewest_; }
    [[nodiscard]] bool sawRays() const { return !rays_[0].empty() || !rays_[1].empty(); }
    [[nodiscard]] int mostBounces() const { return log_.mostBounces(); }
    /// Mean of the colours that the pixel's rays meet.
    [[nodiscard]] ColourRGB meanOfRays(std::size_t pixel) const;

private:
    void sortRays();

    Scene unwatched_;
    RayLog log_;
    std::array<std::vector<ColourRGB>, 2> colours_;
    std::array<std::vector<Ray>, 2> rays_;
    std::size_t fewest_ = 0;
    bool started_ = false;
};

/// Task T2.2, Renderer::render: shared parts of its public tests.
class DepthOfField : public ::testing::Test {
protected:
    /// Skips a task that is not attempted.
    void SetUp() override;

    /// One series of renders serves all tests.
    static const Trial& trial();

    const RenderSettings handout_{};
};

}  // namespace raytracer::tests::lens

#endif
