#ifndef TICKER_TASKS_MAINTICK_MIRRORFINDINGS_H
#define TICKER_TASKS_MAINTICK_MIRRORFINDINGS_H

#include <grader/result/FindingText.h>

#include <array>

namespace ticker::tasks {

// What can be said about reflections (M4).

inline constexpr std::string_view kMirrorSection = "Reflections (M4)";

inline constexpr FindingText kMirrorEndless{
    .id = "mirror.endless",
    .words = "followed reflections without end",
    .meaning = "two mirrors that face each other end the program",
    .hint = "Hand bouncesLeft - 1 on to trace, and return the direct light where bouncesLeft is 0.",
    .section = kMirrorSection};
inline constexpr FindingText kMirrorBackground{
    .id = "mirror.background",
    .words = "changed the background",
    .meaning = "a ray that meets nothing has another colour than kBackgroundColour",
    .hint = "Return kBackgroundColour where nothing is hit, for mirrored rays, too.",
    .section = kMirrorSection};
inline constexpr FindingText kMirrorBase{
    .id = "mirror.base",
    .words = "changed the direct light where no mirror counts",
    .meaning = "without bounces, or on a dull surface, the colour is not the direct light",
    .hint =
        "Where bouncesLeft is 0, or object.reflectivity() is 0, return the direct light as it "
        "is.",
    .section = kMirrorSection};
inline constexpr FindingText kMirrorNone{
    .id = "mirror.none",
    .words = "showed nothing in mirrors",
    .meaning = "the colour is the direct light however many bounces are left",
    .hint =
        "Where bounces are left, trace the mirrored ray and blend: direct * (1 - rho) + "
        "reflected * rho.",
    .section = kMirrorSection};
inline constexpr FindingText kMirrorDirection{
    .id = "mirror.direction",
    .words = "mirrored rays into a wrong direction",
    .meaning = "the reflected ray leaves elsewhere",
    .hint =
        "R is (-ray.direction).reflectIn(N): reflectIn mirrors what points away from the "
        "surface.",
    .section = kMirrorSection};
inline constexpr FindingText kMirrorStart{
    .id = "mirror.start",
    .words = "started mirrored rays in a wrong place",
    .meaning = "the reflected ray does not start just above the point",
    .hint = "Start at P + N * kShadowBias, as shadow rays do.",
    .section = kMirrorSection};
inline constexpr FindingText kMirrorBlend{
    .id = "mirror.blend",
    .words = "blended mirrored light wrongly",
    .meaning = "the two shares are not 1 - rho and rho",
    .hint = "The colour is direct * (1 - rho) + reflected * rho, with rho = object.reflectivity().",
    .section = kMirrorSection};
inline constexpr FindingText kMirrorBounces{
    .id = "mirror.bounces",
    .words = "followed too few or too many bounces",
    .meaning = "right for one bounce, wrong for another number",
    .hint = "Call trace with bouncesLeft - 1; it ends where bouncesLeft is 0.",
    .section = kMirrorSection};
inline constexpr FindingText kMirrorWrong{
    .id = "mirror.wrong",
    .words = "got reflections wrong",
    .meaning = "no known mistake gives these colours",
    .hint =
        "R = (-ray.direction).reflectIn(N), start P + N * kShadowBias, colour direct * (1 - "
        "rho) + trace(...) * rho, where rho is object.reflectivity() as it is, read in each call.",
    .section = kMirrorSection};

inline constexpr FindingText kMirrorThreadsMixed{
    .id = "mirror.threads-mixed",
    .words = "let threads share their mirrored rays",
    .meaning = "right with one thread, another picture with two",
    .hint =
        "forEachPixel calls your code from several threads at once: a static or global variable "
        "belongs to all of them. Declare it inside of the function, without static.",
    .section = kMirrorSection};

inline constexpr std::array kMirrorFindings{
    &kMirrorEndless, &kMirrorBackground, &kMirrorBase,    &kMirrorNone,         &kMirrorDirection,
    &kMirrorStart,   &kMirrorBlend,      &kMirrorBounces, &kMirrorThreadsMixed, &kMirrorWrong};

}  // namespace ticker::tasks

#endif
