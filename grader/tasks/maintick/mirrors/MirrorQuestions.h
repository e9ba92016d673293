#ifndef TICKER_TASKS_MAINTICK_MIRRORS_MIRRORQUESTIONS_H
#define TICKER_TASKS_MAINTICK_MIRRORS_MIRRORQUESTIONS_H

#include <grader/probe/Question.h>
#include <grader/tasks/maintick/TraceModel.h>

#include <cstdint>

namespace ticker::tasks::maintick {

/// Rays to trace, and the points whose direct light is asked of the same code.
struct MirrorQuestion {
    probe::IlluminateQuestion direct;
    probe::TraceQuestion question;
};

/// A scene with ambient light alone, so that each object has one colour. Every chain of mirrors
/// ends. It meets the same objects if reflected rays start anywhere from 1e-6 to 0.001 above the
/// surface, and if the first ray turns by 0.01 radians. `direct` asks each object once.
[[nodiscard]] MirrorQuestion drawOpenScene(std::uint64_t seed);

/// Two planes that show each other in the light, one ray with 0, 1 and 2 bounces. `direct` asks the
/// points of its chain in order.
[[nodiscard]] MirrorQuestion drawFacingMirrors(std::uint64_t seed);

/// Most bounces that are asked for: more than a table of 16 reflections holds, and few enough for
/// code that calls trace twice for each reflection, whose calls double with each bounce.
inline constexpr int kDeepest = 18;

/// Two parallel mirrors in ambient light alone, each of one colour: whatever the start of a
/// reflected ray, the chain is the same. One ray with 4 to 10 and with `kDeepest` bounces, the
/// fewest first. `direct` asks each object once.
[[nodiscard]] MirrorQuestion drawDeepMirrors(std::uint64_t seed);

/// A ray that all but grazes a mirror, in ambient light alone, and then meets a wall. One ray with
/// 1 and 2 bounces. `direct` asks each object once.
[[nodiscard]] MirrorQuestion drawGrazedMirror(std::uint64_t seed);

/// The right colour of a ray with `bounces` left, from the direct light of the points of its chain.
[[nodiscard]] ColourRGB alongChain(const MirrorQuestion& asked,
                                   const std::vector<ColourRGB>& direct, int bounces);

}  // namespace ticker::tasks::maintick

#endif
