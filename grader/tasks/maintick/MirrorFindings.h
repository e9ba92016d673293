#ifndef TICKER_TASKS_MAINTICK_MIRRORFINDINGS_H
#define TICKER_TASKS_MAINTICK_MIRRORFINDINGS_H

#include <grader/result/FindingText.h>

#include <array>

namespace ticker::tasks {

// What can be said about reflections (M4).

inline constexpr std::string_view kMirrorSection = "Reflections (M4)";

inline constexpr FindingText kMirrorEndless{
    "mirror.endless", "followed reflections without end",
    "two mirrors that face each other end the program",
    "Hand bouncesLeft - 1 on to trace, and return the direct light where bouncesLeft is 0.",
    kMirrorSection};
inline constexpr FindingText kMirrorBackground{
    "mirror.background", "changed the background",
    "a ray that meets nothing has another colour than kBackgroundColour",
    "Return kBackgroundColour where nothing is hit, for mirrored rays, too.", kMirrorSection};
inline constexpr FindingText kMirrorBase{
    "mirror.base", "changed the direct light where no mirror counts",
    "without bounces, or on a dull surface, the colour is not the direct light",
    "Where bouncesLeft is 0, or object.reflectivity() is 0, return the direct light as it is.",
    kMirrorSection};
inline constexpr FindingText kMirrorNone{
    "mirror.none", "showed nothing in mirrors",
    "the colour is the direct light however many bounces are left",
    "Where bounces are left, trace the mirrored ray and blend: direct * (1 - rho) + reflected * "
    "rho.",
    kMirrorSection};
inline constexpr FindingText kMirrorDirection{
    "mirror.direction", "mirrored rays into a wrong direction",
    "the reflected ray leaves elsewhere",
    "R is (-ray.direction).reflectIn(N): reflectIn mirrors what points away from the surface.",
    kMirrorSection};
inline constexpr FindingText kMirrorStart{"mirror.start", "started mirrored rays in a wrong place",
                                          "the reflected ray does not start just above the point",
                                          "Start at P + N * kShadowBias, as shadow rays do.",
                                          kMirrorSection};
inline constexpr FindingText kMirrorBlend{
    "mirror.blend", "blended mirrored light wrongly", "the two shares are not 1 - rho and rho",
    "The colour is direct * (1 - rho) + reflected * rho, with rho = object.reflectivity().",
    kMirrorSection};
inline constexpr FindingText kMirrorBounces{
    "mirror.bounces", "followed too few or too many bounces",
    "right for one bounce, wrong for another number",
    "Call trace with bouncesLeft - 1; it ends where bouncesLeft is 0.", kMirrorSection};
inline constexpr FindingText kMirrorWrong{
    "mirror.wrong", "got reflections wrong", "no known mistake gives these colours",
    "R = (-ray.direction).reflectIn(N), reflected = Ray{P + N * kShadowBias, R}, colour direct * "
    "(1 - rho) + trace(scene, reflected, bouncesLeft - 1) * rho, where rho is "
    "object.reflectivity() as it is, in a variable of this call (const double, not static or "
    "global: the trace of the mirrored ray would change it).",
    kMirrorSection};

inline constexpr FindingText kMirrorThreadsMixed{
    "mirror.threads-mixed", "let threads share their mirrored rays",
    "right with one thread, another picture with two",
    "forEachPixel calls your code from several threads at once: a static or global variable "
    "belongs to all of them. Declare it inside of the function, without static.",
    kMirrorSection};

inline constexpr std::array kMirrorFindings{
    &kMirrorEndless, &kMirrorBackground, &kMirrorBase,    &kMirrorNone,         &kMirrorDirection,
    &kMirrorStart,   &kMirrorBlend,      &kMirrorBounces, &kMirrorThreadsMixed, &kMirrorWrong};

}  // namespace ticker::tasks

#endif
