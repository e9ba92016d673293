#ifndef TICKER_ORACLE_SETUP_H
#define TICKER_ORACLE_SETUP_H

#include <grader/oracle/BallPool.h>
#include <grader/oracle/Reading.h>
#include <grader/oracle/SceneSoA.h>

#include <raytracer/base/RenderSettings.h>
#include <raytracer/scene/SceneDescription.h>

#include <cstddef>
#include <vector>

namespace ticker::oracle {

/// Everything that stays constant while a picture is computed: scene, settings, reading and
/// mistakes, in the form that the kernels use. World units, single precision.
struct Setup {
    Setup(const raytracer::SceneDescription& description,
          const raytracer::RenderSettings& renderSettings, const Reading& chosenReading,
          const Mistake& chosenMistake, const Tricks& chosenTricks);

    SceneSoA scene;
    raytracer::RenderSettings settings;
    Reading reading;
    Mistake mistake;
    Tricks tricks;

    int width = 0;  ///< of the region that is rendered
    int height = 0;

    float pitch = 0.0F;     ///< distance of neighbouring pixels on the plane z = 1
    float leftmost = 0.0F;  ///< x of the region's first pixel on that plane
    float topmost = 0.0F;   ///< y of the region's first pixel on that plane
    float focal = 0.0F;     ///< distance of the focal plane in z, or along the ray
    float lensHalf = 0.0F;
    float lensOffsetX = 0.0F;
    float lensOffsetY = 0.0F;

    float pixelSpread = 0.0F;
    std::size_t lensDimensions = 2;  ///< dimensions of a path's samples before its shadow rays

    float lightRadius = 0.0F;  ///< of the shape that aim points are drawn from
    float aimBound = 0.0F;     ///< no aim point is farther from the aim's centre
    float aimOffset[3] = {};   ///< of the aim's centre from the light's centre
    float shadowBias = 0.0F;
    int shadowRays = 1;  ///< rays that can differ: 1 if all go to the centre

    /// A light's contribution depends on the share of rays that arrive and on nothing else of its
    /// samples, so one number describes them.
    bool contributionIsShare = true;
    bool lightIsSplit = false;  ///< a mistake changes which part of a light is shaded, or how much
    bool conesHold = true;      ///< cone tests are valid for this reading and mistake
    bool closedFormsHold = true;  ///< likewise the closed forms of Closed-inl.h

    /// One node of the Gauss-Legendre quadrature over half a turn, on the unit interval.
    struct Node {
        float position;
        float weight;
    };
    std::vector<Node> nodes;

    BallPool pool;  ///< aim points for student renders, radius included
};

/// Whether the settings' monitor has asked to stop.
[[nodiscard]] bool interrupted(const Setup& setup);

}  // namespace ticker::oracle

#endif
