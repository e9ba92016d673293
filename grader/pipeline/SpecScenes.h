#ifndef TICKER_PIPELINE_SPECSCENES_H
#define TICKER_PIPELINE_SPECSCENES_H

#include <grader/result/SubmissionResult.h>

#include <grader/probe/Examinee.h>

#include <raytracer/base/RenderSettings.h>
#include <raytracer/io/ImageReader.h>
#include <raytracer/scene/SceneDescription.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ticker::pipeline {

/// One of the handout's scenes as every submission renders it for people to look at, and what it
/// should look like. Never changes, so threads may share it.
struct SpecScene {
    std::string name;  ///< "bump-mapping"
    bool isForT1 = true;
    raytracer::SceneDescription scene;
    raytracer::RenderSettings settings;
    raytracer::ByteImage expected;
};

/// The handout's two scenes and bumpmap-test. Option 2's is small: its many rays cost more than the
/// rest of the grading.
/// @throws raytracer::InputError where a scene or a map cannot be read.
[[nodiscard]] std::vector<SpecScene> readSpecScenes(const std::filesystem::path& scenes,
                                                    const std::filesystem::path& assets);

/// The picture that came, through the tone curve; empty where some of it is missing.
[[nodiscard]] std::optional<raytracer::ByteImage> pictureFrom(const probe::RenderAnswer& answer);

/// Asks the submission for the pictures of its option and puts them into the result, with scores
/// against what was expected. A picture that did not come is left out; nothing is decided by it.
void addRenders(SubmissionResult& result, const std::vector<SpecScene>& scenes, bool isT1,
                probe::Examinee& examinee);

}  // namespace ticker::pipeline

#endif
