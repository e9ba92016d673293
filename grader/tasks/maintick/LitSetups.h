#ifndef TICKER_TASKS_MAINTICK_LITSETUPS_H
#define TICKER_TASKS_MAINTICK_LITSETUPS_H

#include <grader/probe/Question.h>
#include <grader/tasks/maintick/PhongModel.h>
#include <grader/tasks/support/Draw.h>

#include <cstdint>
#include <vector>

namespace ticker::tasks::maintick {

/// What a question is about.
enum class LitKind : std::uint8_t {
    ambient,
    diffuse,
    specular,
    behind,
    several,
    bright,
    far,  ///< lit from 120 away, or from 0.12
    all,
    many,   ///< twenty lights
    shiny,  ///< an alpha of 260 or more
    faint,  ///< a light that adds less than a byte of a picture shows
    pure    ///< a light, or a surface, with one channel alone
};

struct LitQuestion {
    LitKind kind = LitKind::all;
    LitSetup setup;
};

/// A point, its normal and a viewer, without lights. The object is a sphere of radius 0.02 whose
/// centre lies 3 world units below the point, so that nothing casts a shadow. A normal that code
/// computes from that sphere equals the given one.
[[nodiscard]] LitSetup drawPoint(Draw& draw);

/// How far P lies above or below its surface, world units: rounding moves the points of a render in
/// this way. It is a hundred times the rounding error of these questions, so that its sign is
/// certain.
inline constexpr double kRounding = 1e-13;

/// Makes the ambient light and the point light so faint that each adds less than one step of a
/// byte, and no tolerance hides either.
/// @param setup  Has one light.
void dim(Draw& draw, LitSetup& setup);

/// Moves the object, a sphere, until P lies on it, `height` above (below if negative).
void layOnSphere(LitSetup& setup, double radius, double height);

/// A copy whose object is a sphere of radius 1 that P lies on.
[[nodiscard]] LitSetup onItsSurface(LitSetup setup);

/// Adds a coloured light, and moves O. No cosine is near a limit: N.L is 0.3 to 0.8, and R.V is
/// 0.75 to 0.93 as seen from the new O.
/// @param distance  From the point, world units.
void addLight(Draw& draw, LitSetup& setup, double distance, double intensity);

/// The same with N.L from 0.02 to 0.04.
void addGrazingLight(Draw& draw, LitSetup& setup, double distance, double intensity);

/// The questions of M2.
[[nodiscard]] std::vector<LitQuestion> drawLitQuestions(std::uint64_t seed);

[[nodiscard]] probe::IlluminateQuestion questionOf(const LitSetup& setup);

}  // namespace ticker::tasks::maintick

#endif
