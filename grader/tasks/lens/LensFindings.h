#ifndef TICKER_TASKS_LENS_LENSFINDINGS_H
#define TICKER_TASKS_LENS_LENSFINDINGS_H

#include <grader/result/GeneralFindings.h>

#include <array>

namespace ticker::tasks {

// The findings of T2.2. A new finding is one row here and one entry in the table below.

inline constexpr FindingText kDofNone{
    .id = "dof.none",
    .words = "let every ray start at the eye",
    .meaning = "every ray starts at the eye",
    .hint =
        "Start every ray, in every pixel, at a random point of the aperture (x and y each from "
        "-dofAmount to dofAmount, z 0) and send it through the focal point.",
    .section = "Depth of field (T2.2), step 2"};

inline constexpr FindingText kDofTooFewRays{
    .id = "dof.too-few-rays",
    .words = "cast too few rays for a pixel",
    .meaning = "fewer than `dofRayCount` for a pixel, also none: a neighbour's colour",
    .hint =
        "Cast settings().dofRayCount rays for every pixel, and divide their sum by the same "
        "number.",
    .section = "Depth of field (T2.2), step 2"};

inline constexpr FindingText kDofSharedSamples{
    .id = "dof.shared-samples",
    .words = "shared lens samples between rays",
    .meaning = "one lens sample for the frame, or the eye alone in some pixels",
    .hint =
        "Draw the point of the aperture inside of the loop over the rays, a new one for each. If "
        "it is drawn there, look for a generator that is started again on the way (a seed set in "
        "the loop or in illuminate, a generator made anew): then the numbers repeat. forEachPixel "
        "starts it again for each pixel, too: call that once, with the loop over the rays inside. "
        "And start each ray at its point of the aperture, not at the focal point that it aims at.",
    .section = "Depth of field (T2.2), step 2"};

inline constexpr FindingText kDofNotAveraged{
    .id = "dof.not-averaged",
    .words = "did not average the rays of a pixel",
    .meaning = "a sum, the last sample (divided or not), weights, a median",
    .hint =
        "Add, with +=, what trace returns for each of the dofRayCount lens rays, as it is: no "
        "std::min, pow or tone curve, and the background counts as well. Divide once by their "
        "number, no more and no less. The ray straight from the eye is none of them, the sum is "
        "not static, and no second pass over the picture mixes neighbours.",
    .section = "Depth of field (T2.2), step 3"};

inline constexpr FindingText kDofThreadsMixed{
    .id = "dof.threads-mixed",
    .words = "let several threads share what a pixel adds up",
    .meaning = "right with one thread, wrong with two: pixels share a sum or a counter",
    .hint =
        "forEachPixel works on several rows at the same time. All that a pixel computes must be "
        "its own: declare focal point, sum and counters inside of the function that is given to "
        "forEachPixel, not before it, and neither static nor as members. Threads of your own need "
        "every row between them, also those that are left over when rows are shared out.",
    .section = "Depth of field (T2.2), step 3"};

inline constexpr FindingText kDofFocalDistance{
    .id = "dof.focal-distance",
    .words = "measured the focal distance along the ray",
    .meaning = "the focal distance is measured along the ray",
    .hint =
        "The focal plane lies at z = settings().dofFocalPlane: go along the pinhole ray by "
        "dofFocalPlane / direction.z, not by dofFocalPlane.",
    .section = "Depth of field (T2.2), step 1"};

inline constexpr FindingText kDofFocalPlane{
    .id = "dof.focal-plane",
    .words = "focused on another plane, or none",
    .meaning = "another plane, or none",
    .hint =
        "All rays of a pixel must meet the pinhole ray at z = settings().dofFocalPlane, in every "
        "pixel and whatever the scene shows: aim each exactly at that point, with nothing random "
        "added to it. The length along the pinhole ray is dofFocalPlane divided by direction.z, "
        "not multiplied by it, and with no other factor.",
    .section = "Depth of field (T2.2), step 1"};

inline constexpr FindingText kDofOffCentre{
    .id = "dof.off-centre",
    .words = "put the aperture off the eye",
    .meaning = "the aperture is not centred on the eye",
    .hint =
        "The aperture is centred on the eye: x and y each from -settings().dofAmount to "
        "settings().dofAmount, not from 0, and with nothing added to them. Where it is divided "
        "into cells, every cell needs its ray: 50 rays leave cells of 8 x 8 empty.",
    .section = "Depth of field (T2.2), step 2"};

inline constexpr FindingText kDofDisc{
    .id = "dof.disc",
    .words = "gave the aperture another shape than a square",
    .meaning = "a disc, or any other shape than a square",
    .hint =
        "The aperture is a square in the xy-plane: x and y are two random numbers, each even over "
        "[-dofAmount, dofAmount] (no radius and angle, no point of a disc or of "
        "randomInsideUnitSphere, no product, no normal distribution), both drawn inside of the "
        "loop over the rays, and z is 0.",
    .section = "Depth of field (T2.2), step 2"};

inline constexpr FindingText kDofApertureSize{
    .id = "dof.aperture-size",
    .words = "gave the aperture another size",
    .meaning = "a square of another size",
    .hint = "The half-width of the aperture is settings().dofAmount (or half of it).",
    .section = "Depth of field (T2.2), step 2"};

inline constexpr FindingText kDofReusedPattern{
    .id = "dof.reused-pattern",
    .words = "used one pattern of rays for all pixels",
    .meaning = "warn: one pattern of many points for every pixel, or for every one of a row",
    .hint =
        "Draw new points of the aperture for every pixel, and start no generator again (with "
        "seedRandom, say): forEachPixel does so for each pixel.",
    .section = "Depth of field (T2.2), step 2"};

inline constexpr FindingText kDofAntialiased{
    .id = "dof.antialiased",
    .words = "sent each ray through another place of its pixel",
    .meaning =
        "warn: each ray of a pixel goes through another place of the pixel's own square of the "
        "focal plane (antialiasing): accepted",
    .hint =
        "The handout asks for one focal point for each pixel, found before the loop over its rays. "
        "Antialiasing on top of that is accepted.",
    .section = "Depth of field (T2.2), step 1"};

inline constexpr FindingText kDofPictureDiffers{
    .id = "dof.picture-differs",
    .words = "rendered a picture that its answers do not explain",
    .meaning =
        "warn, for a person: all answers are right, but the picture of the handout's scene is "
        "another one or has another aperture, or none came",
    .hint =
        "Look for what render and illuminate share, such as a generator that illuminate seeds "
        "anew, so that all rays of a pixel start at one point of the lens; and for anything that "
        "depends on the size of the picture or on the number of lights.",
    .section = "Test and submit"};

inline constexpr FindingText kDofUnseenRays{
    .id = "dof.unseen-rays",
    .words = "cast camera rays that cannot be seen",
    .meaning =
        "note: no camera ray was seen, or not those of all pixels, or more than can be followed, "
        "so pictures were judged; warn, for a person: they left it open"};

inline constexpr FindingText kDofWrong{
    .id = "dof.wrong",
    .words = "blurred in no known way",
    .meaning =
        "fits nothing known; also what one render keeps for the next (rays, focal points, the "
        "camera)",
    .hint =
        "Compare with the steps of the handout: for every pixel dofRayCount calls of trace(scene, "
        "ray, settings().bounces), which adds the reflections, their mean, and one image.set.",
    .section = "Depth of field (T2.2), step 3"};

/// In the order in which they are reported.
inline constexpr std::array kLensFindings{
    &kDofNone,           &kDofTooFewRays,    &kDofSharedSamples,  &kDofNotAveraged,
    &kDofThreadsMixed,   &kDofFocalDistance, &kDofFocalPlane,     &kDofOffCentre,
    &kDofDisc,           &kDofApertureSize,  &kDofReusedPattern,  &kDofAntialiased,
    &kDofPictureDiffers, &kDofWrong,         &kSettingsHardCoded, &kDofUnseenRays};

}  // namespace ticker::tasks

#endif
