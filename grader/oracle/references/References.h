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

/// The expected picture of a scene, in linear colours: the mean of infinitely many student renders,
/// as well as `lensPaths` paths for each pixel tell it; 0: until its error is below 0.0005 (RMS).
[[nodiscard]] raytracer::Image renderWithOracle(const raytracer::SceneDescription& scene,
                                                const raytracer::RenderSettings& settings,
                                                std::uint64_t seed, int lensPaths = 0);

/// The same as the template renders it: one hard shadow ray, no aperture. This is how option 1's
/// scenes are seen.
[[nodiscard]] raytracer::Image renderPinholeWithOracle(const raytracer::SceneDescription& scene,
                                                       const raytracer::RenderSettings& settings);

/// One picture of the reference folder.
struct ReferenceScene {
    std::string name;  ///< of the files: "distributed"
    raytracer::SceneDescription scene;
    raytracer::RenderSettings settings;
    bool pinhole = false;  ///< as the template renders: for option 1
};

struct ReferenceOptions {
    std::uint64_t seed = 0;   ///< not to be published
    double rms = 1e-4;        ///< wanted error of the means, linear
    std::string toolVersion;  ///< goes into the manifest
};

/// Told before and after every scene. `secondsLeft` is an estimate; negative: not known yet.
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
/// version, instruction set). Every file is written whole or not at all; a scene's files are
/// replaced only when all of it is rendered. Stops before the next scene's files when the settings'
/// monitor says so.
/// @return  False where it was interrupted.
/// @throws raytracer::InputError where the folder cannot be written.
bool writeReferences(const std::filesystem::path& folder, const std::vector<ReferenceScene>& scenes,
                     const ReferenceOptions& options, const ReferenceListener& listener = {});

/// What became of one reference.
struct ReferenceCheck {
    std::string scene;
    bool passed = false;
    bool sceneChanged = false;   ///< the manifest has another scene hash
    double largestZ = 0.0;       ///< over tiles of 8 x 8 pixels and channels
    double varianceRatio = 1.0;  ///< sum of variances, new / stored
    std::string message;         ///< one line that names the scene
};

/// Renders every scene anew, with another seed, and compares it with the stored files. A sound
/// reference fails with a probability below 1e-6; a light whose intensity is 2 % off fails.
/// @throws raytracer::InputError where a file is missing or damaged.
[[nodiscard]] std::vector<ReferenceCheck> checkReferences(const std::filesystem::path& folder,
                                                          const std::vector<ReferenceScene>& scenes,
                                                          const ReferenceOptions& options,
                                                          const ReferenceListener& listener = {});

}  // namespace ticker::oracle

#endif
