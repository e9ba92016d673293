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

/// A point, its normal and a viewer, without lights. The object is a small sphere well below the
/// point, whose normal there is the right one: nothing casts a shadow, and a normal that code works
/// out itself is the same.
[[nodiscard]] LitSetup drawPoint(Draw& draw);

/// How far P lies above its surface or below it, as rounding puts the points of a render: a hundred
/// times what rounding does to these questions, so that its sign is certain.
inline constexpr double kRounding = 1e-13;

/// Ambient light and a point light so faint that no tolerance hides either: both add less than one
/// step of a byte.
/// @param setup  Has one light.
void dim(Draw& draw, LitSetup& setup);

/// Moves the object, a sphere, until P lies on it, `height` above (below if negative).
void layOnSphere(LitSetup& setup, double radius, double height);

/// A copy whose object is a sphere of radius 1 that P lies on.
[[nodiscard]] LitSetup onItsSurface(LitSetup setup);

/// A light whose cosines are off their edges: N.L from 0.3 to 0.8, R.V from 0.75 to 0.93 as seen
/// from the setup's O, which is moved. Coloured.
/// @param distance  From the point.
void addLight(Draw& draw, LitSetup& setup, double distance, double intensity);

/// The same, but for N.L from 0.02 to 0.04.
void addGrazingLight(Draw& draw, LitSetup& setup, double distance, double intensity);

/// The questions of M2.
[[nodiscard]] std::vector<LitQuestion> drawLitQuestions(std::uint64_t seed);

[[nodiscard]] probe::IlluminateQuestion questionOf(const LitSetup& setup);

}  // namespace ticker::tasks::maintick

#endif
