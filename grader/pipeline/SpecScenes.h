#ifndef TICKER_PIPELINE_SPECSCENES_H
#define TICKER_PIPELINE_SPECSCENES_H

#include <grader/exercise/Exercise.h>
#include <grader/exercise/Task.h>
#include <grader/pipeline/Expectation.h>
#include <grader/result/SubmissionResult.h>

#include <grader/probe/Examinee.h>

#include <raytracer/base/RenderSettings.h>
#include <raytracer/io/ImageReader.h>
#include <raytracer/scene/SceneDescription.h>

#include <cstddef>
#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::pipeline {

/// One of the handout's scenes as every submission renders it for people to look at, and what it
/// should look like. Never changes but for expectations that are worked out when somebody first
/// asks, so threads may share it.
struct SpecScene {
    std::string name;
    std::string file;        ///< whose tasks it shows
    bool isRandom = false;   ///< two right renders differ by noise
    bool isHandedIn = true;  ///< a screenshot of it is what the handout asks for
    raytracer::SceneDescription scene;
    raytracer::RenderSettings settings;
    /// One for each accepted reading that looks different, the handout's first.
    std::vector<std::shared_future<Expectation>> expectations;
    std::vector<oracle::Reading> readings;  ///< of each, where it is random

    [[nodiscard]] const Expectation& expected(std::size_t reading = 0) const {
        // A future of its own for each thread, as the library asks for.
        return std::shared_future{expectations.at(reading)}.get();
    }
};

/// A submission's picture of a scene.
struct Rendered {
    std::string scene;
    raytracer::ByteImage picture;
};

/// The exercise's scenes. A random one should be small: its many rays cost more than the rest of
/// the grading. Reading them takes some 20 ms, what each should look like 50 to 300 more.
/// @throws raytracer::InputError where a scene or a map cannot be read.
[[nodiscard]] std::vector<SpecScene> readSpecScenes(const std::filesystem::path& scenes,
                                                    const std::filesystem::path& assets,
                                                    const Exercise& exercise = theExercise());

/// How far a picture of a random scene is from the accepted readings; those that come later are
/// tried only where the ones before do not fit.
[[nodiscard]] std::vector<Misfit> misfitsOf(const SpecScene& scene,
                                            const probe::RenderAnswer& answer);

/// The picture that came, through the tone curve; empty where some of it is missing.
[[nodiscard]] std::optional<raytracer::ByteImage> pictureFrom(const probe::RenderAnswer& answer);

/// What a submission renders, for people to look at.
struct Gallery {
    std::vector<Rendered> rendered;
    std::vector<RenderScore> scores;      ///< against the expectation that fits best
    std::vector<ResultPicture> pictures;  ///< that the scores name
    /// Of the random scene, beside each expectation that was tried. Empty where the picture did not
    /// come.
    std::vector<Misfit> misfits;
    /// The largest `tasks::bumpMisfit`; empty: no scene has a relief, or a picture did not come.
    std::optional<double> bumpMisfit;

    /// Puts scores and pictures into the result. @return  What was rendered.
    std::vector<Rendered> moveTo(SubmissionResult& result) &&;
};

/// Asks the submission for the pictures of a file's scenes. A picture that did not come is left
/// out. Pictures fail no submission; a misfit may leave it to a person (tasks/lens/PictureDoubt.h,
/// tasks/bump/BumpPicture.h).
[[nodiscard]] Gallery renderSpecScenes(const std::vector<SpecScene>& scenes, std::string_view file,
                                       probe::Examinee& examinee);

/// Works out ahead what the scenes of a file should look like.
void prepareExpectations(const std::vector<SpecScene>& scenes, std::string_view file);

}  // namespace ticker::pipeline

#endif
