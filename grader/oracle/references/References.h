#ifndef TICKER_ORACLE_REFERENCES_H
#define TICKER_ORACLE_REFERENCES_H

#include <grader/oracle/Oracle.h>

#include <raytracer/base/RenderSettings.h>
#include <raytracer/image/Image.h>
#include <raytracer/scene/SceneDescription.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ticker::oracle {

/// The expected picture of a scene, in linear colours: the mean over infinitely many student
/// renders, estimated from `lensPaths` paths for each pixel; 0: until its error is below 0.0005
/// (RMS).
[[nodiscard]] raytracer::Image renderWithOracle(const raytracer::SceneDescription& scene,
                                                const raytracer::RenderSettings& settings,
                                                std::uint64_t seed, int lensPaths = 0);

/// The picture that the template's renderer gives, as for option 1's scenes: a pinhole camera and
/// one shadow ray to the centre of each light.
[[nodiscard]] raytracer::Image renderPinholeWithOracle(const raytracer::SceneDescription& scene,
                                                       const raytracer::RenderSettings& settings);

/// One picture of the reference folder.
struct ReferenceScene {
    std::string name;  ///< of the files
    raytracer::SceneDescription scene;
    raytracer::RenderSettings settings;
    bool pinhole = false;  ///< rendered like the template: for option 1
};

struct ReferenceOptions {
    std::uint64_t seed = 0;   ///< not to be published
    double rms = 1e-4;        ///< wanted error of the means, linear
    std::string toolVersion;  ///< goes into the manifest
};

/// Progress over a list of scenes, reported before every scene and after the last one.
/// `secondsLeft` is an estimate; negative: not known yet.
struct ReferenceProgress {
    std::string scene;
    int done = 0;
    int total = 0;
    double secondsLeft = -1.0;
};
using ReferenceListener = std::function<void(const ReferenceProgress&)>;

/// Renders every scene and writes, for each, NAME.png (8 bits, for people), NAME-mean.tiff,
/// NAME-variance.tiff (of one student render) and NAME-error.tiff (squared standard error of the
/// mean), all three with 32-bit floats, and manifest.json (scene hash, settings, paths, seed, tool
/// version, instruction set). Every file is written atomically; a scene's files are replaced only
/// after the whole scene is rendered. An interrupt by the settings' monitor stops before the next
/// scene's files.
/// @return  False if it was interrupted.
/// @throws raytracer::InputError if the folder cannot be written.
bool writeReferences(const std::filesystem::path& folder, const std::vector<ReferenceScene>& scenes,
                     const ReferenceOptions& options, const ReferenceListener& listener = {});

/// How one reference compares with a fresh render.
struct ReferenceCheck {
    std::string scene;
    bool passed = false;
    bool sceneChanged = false;   ///< the manifest has another scene hash
    double largestZ = 0.0;       ///< over tiles of 8 x 8 pixels and channels
    double varianceRatio = 1.0;  ///< sum of variances, new / stored
    std::string message;         ///< one line that names the scene
};

/// Renders every scene again, with another seed, and compares it with the stored files. An intact
/// reference fails with a probability below 1e-6; a light whose intensity is 2 % off fails.
/// @throws raytracer::InputError if a file is missing or damaged.
[[nodiscard]] std::vector<ReferenceCheck> checkReferences(const std::filesystem::path& folder,
                                                          const std::vector<ReferenceScene>& scenes,
                                                          const ReferenceOptions& options,
                                                          const ReferenceListener& listener = {});

}  // namespace ticker::oracle

#endif
