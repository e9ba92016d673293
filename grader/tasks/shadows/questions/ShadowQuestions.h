#ifndef TICKER_TASKS_SHADOWS_QUESTIONS_SHADOWQUESTIONS_H
#define TICKER_TASKS_SHADOWS_QUESTIONS_SHADOWQUESTIONS_H

#include <grader/probe/Question.h>

#include <cstdint>
#include <vector>

namespace ticker::tasks {

/// Zone of a point for a spherical light, from geometry alone, with a margin around the light.
enum class Zone { lit, umbra, penumbra };

/// A question about `illuminate`, and its purpose.
struct ShadowQuestion {
    enum class Purpose {
        oneLight,       ///< an occluder between a light and a floor: lit, umbra and penumbra points
        severalLights,  ///< three lights far apart in direction, two of them with an occluder
        eightLights,    ///< eight lights in plain sight
        beyondLight,    ///< an object behind the light: every point is lit
        planeShadow,    ///< a wall on the floor hides the light from the points behind it
        farLight,       ///< a single light, a hundred units away: shows where the rays aim
        lightBehind,    ///< three lights, the second behind the surface: the other two light it
        otherSettings,  ///< like oneLight or in plain sight, with other ray counts and light sizes
        inLine,         ///< spheres one behind the other, before the light and beyond it
        contact,        ///< a ball that rests on the floor, and points close to where it does
        horizon,        ///< a light on the horizon of a floor: a part of it is below
        lowLight,       ///< viewers on the side of a low light, where R.V is below 0: no highlight
        nearLight,      ///< a plane just before the light hides it from all points
        pureColours,    ///< lights, or surfaces, each of which has one channel alone
        faintLight,     ///< a light that adds little: it is weak, or shines along the surface
        closeLight,     ///< a light little more than three of its radii away, or less than two
        backSide,       ///< light and viewers behind the surface: ambient light alone
        oddCount,       ///< like oneLight, with an odd number of rays below the handout's
        oneTerm,        ///< a surface that shows its highlight alone, or its diffuse term alone
        mirror,         ///< a surface of reflectivity 1
        enclosed,       ///< a ball around the light, or around the points
        betweenLights,  ///< a ball before one light and behind another
        behindAlone,    ///< a light behind the surface, whose mirrored direction is the viewer's
        behindAfter,    ///< the same after a light in front
        lightsInLine,   ///< a light behind another one's ball
        oneRay,         ///< a single ray to the light
        manyRays,       ///< more rays than fit into a byte
        mixed,          ///< every attribute usual or extreme
        mixedNear       ///< the same with smaller lights, some of them nearer than 1
    };
    Purpose purpose = Purpose::oneLight;
    probe::IlluminateQuestion question;
    std::vector<std::vector<Zone>> zones;  ///< [point][light]
};

/// Draws the questions of T2.1. All but `otherSettings`, `oddCount`, `oneRay`, `manyRays` and
/// `mixedNear` use the handout's settings.
[[nodiscard]] std::vector<ShadowQuestion> drawShadowQuestions(std::uint64_t seed);

}  // namespace ticker::tasks

#endif
