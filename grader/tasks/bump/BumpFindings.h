#ifndef TICKER_TASKS_BUMP_BUMPFINDINGS_H
#define TICKER_TASKS_BUMP_BUMPFINDINGS_H

#include <grader/result/FindingText.h>

#include <array>

namespace ticker::tasks {

// The findings of T1. A new finding is one row here and one entry in the table below.

inline constexpr FindingText kBumpNotFinite{.id = "bump.not-finite",
                                            .words = "gave normals with NaN or infinity in them",
                                            .meaning = "a normal has a NaN or infinite component"};

inline constexpr FindingText kBumpNotUnit{
    .id = "bump.not-unit",
    .words = "gave normals of another length than 1",
    .meaning = "a normal has another length than 1 (only at poles or on tiny maps: warn)"};

inline constexpr FindingText kBumpFlat{
    .id = "bump.flat",
    .words = "showed no bumps at all",
    .meaning = "the tilt nowhere differs from the smooth normal"};

inline constexpr FindingText kBumpLongitudeDependent{
    .id = "bump.longitude-dependent",
    .words = "tilted the same slope differently round the sphere",
    .meaning =
        "the same slope tilts differently round the sphere; also tangents of another "
        "parametrisation, or a factor that depends on the place"};

inline constexpr FindingText kBumpSwappedAxes{
    .id = "bump.swapped-axes",
    .words = "swapped the axes of the bumps",
    .meaning = "a slope along u tilts along v, and the other way round"};

inline constexpr FindingText kBumpInverted{.id = "bump.inverted",
                                           .words = "inverted the bumps along both axes",
                                           .meaning = "both axes inverted: H sunk, L raised"};

inline constexpr FindingText kBumpInvertedU{.id = "bump.inverted-u",
                                            .words = "inverted the bumps along u",
                                            .meaning = "u alone is inverted, on every map"};

inline constexpr FindingText kBumpInvertedV{.id = "bump.inverted-v",
                                            .words = "inverted the bumps along v",
                                            .meaning = "v alone is inverted, on every map"};

inline constexpr FindingText kBumpUpsideDown{.id = "bump.upside-down",
                                             .words = "laid the map upside down",
                                             .meaning = "row 0 of the map lies at the bottom"};

inline constexpr FindingText kBumpThreadsMixed{
    .id = "bump.threads-mixed",
    .words = "let threads share what a normal is made of",
    .meaning = "right with one thread, another picture with two",
    .hint =
        "forEachPixel calls your code from several threads at once: a static or global variable "
        "belongs to all of them. Declare normal, angles, tangents and slopes inside of the "
        "function, without static, and hand them on as arguments.",
    .section = "Option 1: What to do, step 4"};

inline constexpr FindingText kBumpWrong{
    .id = "bump.wrong",
    .words = "tilted normals in no known way",
    .meaning =
        "fits no accepted reading and no single name: what is right on some rows, sizes, greys or "
        "spheres alone, or remembered from an earlier call; slopes that are cut off, heights under "
        "a power or a root, slopes taken "
        "for angles (steep ones turn the normal past the horizon), a wall at the seam, a sum "
        "without n; the message says where and why. warn: a height that the map does not have "
        "beyond its last row, which no usual picture shows"};

inline constexpr FindingText kBumpPictureDiffers{
    .id = "bump.picture-differs",
    .words = "rendered another picture than the bumps that were answered",
    .meaning =
        "warn, for a person: all answers are right, but a picture of the handout's scenes is that "
        "of a smooth sphere, or none came"};

inline constexpr FindingText kBumpMirrored{.id = "bump.mirrored",
                                           .words = "laid the map mirrored",
                                           .meaning = "note: text reads from right to left"};

/// In the order in which they are reported.
inline constexpr std::array kBumpFindings{
    &kBumpNotFinite,   &kBumpNotUnit,      &kBumpFlat,      &kBumpLongitudeDependent,
    &kBumpSwappedAxes, &kBumpInverted,     &kBumpInvertedU, &kBumpInvertedV,
    &kBumpUpsideDown,  &kBumpThreadsMixed, &kBumpWrong,     &kBumpPictureDiffers,
    &kBumpMirrored};

}  // namespace ticker::tasks

#endif
