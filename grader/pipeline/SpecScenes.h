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

/// One of the handout's scenes, which every submission renders for the report, and its expected
/// look. Immutable except for expectations, which are computed on first use, so that threads may
/// share it.
struct SpecScene {
    std::string name;
    std::string file;        ///< the file whose tasks it shows
    bool isRandom = false;   ///< two right renders differ by noise
    bool isHandedIn = true;  ///< the handout asks for a screenshot of it
    raytracer::SceneDescription scene;
    raytracer::RenderSettings settings;
    /// One for each accepted reading with a different look, the handout's first.
    std::vector<std::shared_future<Expectation>> expectations;
    /// Readings of the expectations, if the scene is random.
    std::vector<oracle::Reading> readings;

    [[nodiscard]] const Expectation& expected(std::size_t reading = 0) const {
        // std::shared_future requires a copy for each thread.
        return std::shared_future{expectations.at(reading)}.get();
    }
};

/// A submission's picture of a scene.
struct Rendered {
    std::string scene;
    raytracer::ByteImage picture;
};

/// The exercise's scenes. A random scene should be small: its many rays take longer than the rest
/// of the grading. Reading the scenes takes about 20 ms, each expectation 50 to 300 ms.
/// @throws raytracer::InputError if a scene or a map cannot be read.
[[nodiscard]] std::vector<SpecScene> readSpecScenes(const std::filesystem::path& scenes,
                                                    const std::filesystem::path& assets,
                                                    const Exercise& exercise = defaultExercise());

/// How many camera rays each pixel of a random scene's picture gets.
enum class Rays {
    few,     ///< enough for most submissions, at a quarter of the time
    handout  ///< the handout's number
};
inline constexpr int kFewRays = 12;
/// Pixels on a side of the tiles in which a picture with few rays is compared.
inline constexpr int kTileOfFewRays = 3;

/// The settings of such a picture.
[[nodiscard]] raytracer::RenderSettings settingsFor(const SpecScene& scene, Rays rays);

/// The answered picture after the tone curve; empty if a part is missing.
[[nodiscard]] std::optional<raytracer::ByteImage> pictureFrom(const probe::RenderAnswer& answer);

/// A submission's renders for the report.
struct Gallery {
    std::vector<Rendered> rendered;
    std::vector<RenderScore> scores;      ///< compared with the best fitting expectation
    std::vector<ResultPicture> pictures;  ///< pictures that the scores name
    /// Misfit of the random scene for each expectation that was tried. Empty if the picture is
    /// missing.
    std::vector<Misfit> misfits;
    /// The largest `tasks::bumpMisfit`; empty if no scene has a relief, or if a picture is missing.
    std::optional<double> bumpMisfit;
    /// False if a picture of few rays leaves a doubt that one of the handout's rays may settle.
    bool isClear = true;

    /// Moves scores and pictures into the result. @return  The renders.
    std::vector<Rendered> moveTo(SubmissionResult& result) &&;
};

/// Asks the submission for pictures of a file's scenes; missing pictures are left out. Pictures
/// never fail a submission; a misfit may ask for review (tasks/lens/checks/PictureDoubt.h,
/// tasks/bump/BumpPicture.h).
[[nodiscard]] Gallery renderSpecScenes(const std::vector<SpecScene>& scenes, std::string_view file,
                                       probe::Examinee& examinee, Rays rays = Rays::few);

/// Computes the expectations of a file's scenes in advance.
void prepareExpectations(const std::vector<SpecScene>& scenes, std::string_view file);

}  // namespace ticker::pipeline

#endif
