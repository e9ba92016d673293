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

/// A rendered picture and normals at the same points of its bumpy sphere. Code can recognise the
/// grader's questions and answer them rightly while it draws something else; comparing the two
/// shows it.
struct BumpPicture {
    raytracer::SceneDescription scene;
    std::size_t sphere = 0;           ///< index of the bumpy one
    std::vector<std::size_t> pixels;  ///< counted row after row
    probe::NormalQuestion question;   ///< at these pixels
};

/// Whether the scene has a bumpy sphere.
[[nodiscard]] bool hasRelief(const raytracer::SceneDescription& scene);

/// The pixels of the scene's bumpy sphere and the question about them.
/// @param scene     Contains one bumpy sphere, which nothing hides.
/// @param settings  The picture's settings.
[[nodiscard]] BumpPicture planBumpPicture(const raytracer::SceneDescription& scene,
                                          const raytracer::RenderSettings& settings);

/// Distance of the picture from one shaded with the answered normals, divided by its distance from
/// the smooth sphere's picture (root mean square of bytes). Far below 1 if the code draws what it
/// answers, 1 or more if it draws a smooth sphere.
/// @param rgb  The picture after the tone curve, three bytes for each pixel.
[[nodiscard]] double bumpMisfit(const BumpPicture& plan, const probe::NormalAnswer& answer,
                                const std::vector<std::uint8_t>& rgb);

/// Sends T1 to review if it has passed but its pictures do not show the bumps.
/// @param misfit  The largest misfit of its pictures; empty if a picture is missing.
void doubtBumps(TaskReport& task, const std::optional<double>& misfit);

}  // namespace ticker::tasks

#endif
