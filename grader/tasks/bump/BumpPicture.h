#ifndef TICKER_TASKS_BUMP_BUMPPICTURE_H
#define TICKER_TASKS_BUMP_BUMPPICTURE_H

#include <grader/probe/Question.h>
#include <grader/result/SubmissionResult.h>

#include <raytracer/scene/SceneDescription.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace ticker::tasks {

/// The scene's bumpy sphere, asked about where pixels of a picture show it. Code may know a
/// question from a picture: what it draws is held against what it answers.
struct BumpPicture {
    raytracer::SceneDescription scene;
    std::size_t sphere = 0;           ///< index of the bumpy one
    std::vector<std::size_t> pixels;  ///< counted row after row
    probe::NormalQuestion question;   ///< at these pixels
};

/// @param scene     With one bumpy sphere, which nothing hides.
/// @param settings  Those of the picture.
[[nodiscard]] BumpPicture planBumpPicture(const raytracer::SceneDescription& scene,
                                          const raytracer::RenderSettings& settings);

/// How far the picture is from one that is shaded with the answered normals, over how far it is
/// from the smooth sphere's (root mean square of bytes). Far below 1 where the code draws what it
/// answers, 1 or more where it draws a smooth sphere.
/// @param rgb  The picture through the tone curve, three bytes for each pixel.
[[nodiscard]] double bumpMisfit(const BumpPicture& plan, const probe::NormalAnswer& answer,
                                const std::vector<std::uint8_t>& rgb);

/// Leaves T1 to a person where it has passed, but its pictures do not show it.
/// @param misfit  The largest of its pictures; empty: one did not come.
void doubtBumps(TaskReport& task, const std::optional<double>& misfit);

}  // namespace ticker::tasks

#endif
