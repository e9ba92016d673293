#ifndef TICKER_ORACLE_HIDDENSCENE_H
#define TICKER_ORACLE_HIDDENSCENE_H

#include <grader/oracle/Reading.h>

#include <raytracer/base/RenderSettings.h>
#include <raytracer/scene/SceneDescription.h>

#include <cstdint>
#include <string>
#include <vector>

namespace ticker::oracle {

enum class HiddenTask {
    bump,         ///< T1: one bumpy sphere with an asymmetric map, rendered without T2
    softShadows,  ///< T2.1
    depthOfField  ///< T2.2
};

/// A mistake that a hidden scene ought to show, as the oracle renders it.
struct KnownMistake {
    std::string finding;  ///< the contract's id: "shadow.light-size"
    Reading reading;
    Mistake mistake;
};

/// The mistakes that scenes of a task are measured by: those that change what a picture is on
/// average, and that nothing but a picture shows well.
[[nodiscard]] std::vector<KnownMistake> knownMistakes(HiddenTask task);

/// How well one picture of a scene tells a mistake from the right answer.
struct Separation {
    std::string finding;
    /// T2: distance of the two means in standard deviations of one student render, all pixels'
    /// luminances together (d' of a matched filter). T1, which has no noise: the share of the
    /// luminance that changes (RMS).
    double value = 0.0;
};

/// A scene that no student has seen.
struct HiddenScene {
    raytracer::SceneDescription scene;
    raytracer::RenderSettings settings;  ///< 32 x 24 pixels; light, lens and focus differ, too
    std::vector<Separation> separations;
    double weakest = 0.0;  ///< of the separations
    int rejected = 0;      ///< candidates that were drawn before and told too little
};

/// Draws a scene from a seed: legal (nothing overlaps; camera and lights stand free), lit (neither
/// dark nor burnt out) and informative: every known mistake separates by at least
/// `leastSeparation(task)`. Candidates that fail are redrawn from the same seed.
/// @throws raytracer::Error where 200 candidates in a row fail.
[[nodiscard]] HiddenScene hiddenScene(HiddenTask task, std::uint64_t seed);

/// See `hiddenScene`.
[[nodiscard]] double leastSeparation(HiddenTask task);

/// How a scene separates the known mistakes of a task, whatever it is.
[[nodiscard]] std::vector<Separation> separationsOf(HiddenTask task,
                                                    const raytracer::SceneDescription& scene,
                                                    const raytracer::RenderSettings& settings);

}  // namespace ticker::oracle

#endif
