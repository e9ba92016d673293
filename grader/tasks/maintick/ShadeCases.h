#ifndef TICKER_TASKS_MAINTICK_SHADECASES_H
#define TICKER_TASKS_MAINTICK_SHADECASES_H

#include <grader/tasks/maintick/LitSetups.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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
    itself,           ///< nothing but the surface of the point
    aroundLight,      ///< the light is inside, the point outside
    aroundPoint,      ///< the other way round
    aroundBoth,       ///< light and point are inside
    grazing,          ///< nothing but the surface, which the light all but grazes
    atPointOfFar,     ///< the light at 95, a hit 0.3 from the point
    atFarLight,       ///< the light at 95, a hit 0.3 before it
    beyondFarLight,   ///< the light at 95, a hit 0.3 behind it
    betweenLights,    ///< before the first light, behind the second, which is nearer
    ofFaintLight      ///< half-way to a light that adds less than a byte of a picture shows
};

/// A point that is asked about with an object in the scene that may hide the light, and again
/// without that object. The point lies on its surface, as points of a render do, so that a shadow
/// ray cast from the light hits it there.
struct ShadeCase {
    Occluder place = Occluder::before;
    /// Nothing casts a shadow, and the object is far below the point, so that no shadow ray hits
    /// the point's own surface.
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

/// What an answer equals: the right value, or a telling wrong one.
enum class Shown : std::uint8_t {
    right,
    lit,
    dark,
    black,
    specular,
    diffuse,
    ambientAgain,  ///< right but for ambient light that is added again
    other
};

/// Where the shadow ray of a point starts; if it has several, the first of these that occurs.
enum class RayStart : std::uint8_t { nearPoint, nearLight, alongNormal, elsewhere, unseen };

/// What the same code gives with and without what stands around the point.
struct ShadeSeen {
    const ShadeCase* asked = nullptr;
    ColourRGB given;
    /// Colour in full light, of the floating point. If that is dark, the colour of the point on its
    /// surface in the scene `free`.
    ColourRGB lit;
    ColourRGB dark;
    ColourRGB putOut;    ///< dark as well, see ShadeCase
    ColourRGB specular;  ///< free, without diffuse light
    ColourRGB diffuse;   ///< free, without specular light
    double bias = 0.0;   ///< of the ray that starts farthest from the point; 0: none was seen
    /// The largest cosine between a ray that starts near the point and the way to a light; empty:
    /// no such ray was seen.
    std::optional<double> aim{};
    RayStart start = RayStart::unseen;
    /// Grazing light is lost even at the floating point, while no other light is lost. `lit` is
    /// then dark.
    bool isUnlit = false;

    [[nodiscard]] ColourRGB expected() const;
    [[nodiscard]] bool hasNoLight() const;  ///< `lit` is dark
    [[nodiscard]] Shown shown() const;
};

/// The finding for the mistake at `first`, which all cases together identify, and its hint. An
/// empty hint stands for the finding's own.
[[nodiscard]] std::pair<const FindingText*, std::string> nameOf(const std::vector<ShadeSeen>& seen,
                                                                const ShadeSeen& first);

}  // namespace ticker::tasks::maintick

#endif
