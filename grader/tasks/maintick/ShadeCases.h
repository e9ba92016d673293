#ifndef TICKER_TASKS_MAINTICK_SHADECASES_H
#define TICKER_TASKS_MAINTICK_SHADECASES_H

#include <grader/tasks/maintick/LitSetups.h>

#include <cstdint>
#include <string_view>
#include <vector>

namespace ticker::tasks::maintick {

/// Where something stands, seen from the point.
enum class Occluder : std::uint8_t {
    before,        ///< half-way to the light
    near,          ///< 0.03 from the point
    beyond,        ///< behind the light
    farBeyond,     ///< the light at 3, a hit at 5
    close,         ///< the light at 0.5, a hit at 0.4
    between,       ///< the light at 3, a hit at 2
    backwards,     ///< in the opposite direction
    ofFirstLight,  ///< the second light is free
    ofSecondLight,
    wall,             ///< a plane half-way to the light
    beforeAndBeyond,  ///< one object half-way to the light, one behind it
    itself            ///< nothing but the surface of the point
};

/// A point of an object that is asked about with something around it, and the same without. The
/// point lies on the object, as points of a render do: code that looks from the light meets it
/// there.
struct ShadeCase {
    Occluder place = Occluder::before;
    /// Nothing casts a shadow, and the object is far below the point: code whose shadow ray meets
    /// its own surface lights it.
    LitSetup floating;
    LitSetup free;   ///< nothing casts a shadow
    LitSetup asked;  ///< with the occluder; its object is `object`
    /// No occluder, and the hidden light left out. Code that counts lights may give another colour
    /// than with a light of intensity 0, and either is right in shadow.
    LitSetup without;
    LitSetup putOut;      ///< the same with a light of intensity 0
    int object = 0;       ///< of all but `floating`, whose object is 0
    bool isSunk = false;  ///< the point is a little below the surface, else a little above

    /// Whether the right answer is without the light.
    [[nodiscard]] bool isShaded() const;
};

[[nodiscard]] std::string_view wordsOf(Occluder place);

/// The questions of M3.2. Every hit is at least 0.01 from the light and from the point.
[[nodiscard]] std::vector<ShadeCase> drawShadeCases(std::uint64_t seed);

}  // namespace ticker::tasks::maintick

#endif
