#ifndef TICKER_TASKS_BUMP_CONDUCT_H
#define TICKER_TASKS_BUMP_CONDUCT_H

#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <cstddef>
#include <string>
#include <vector>

namespace ticker::tasks::bump {

/// Kind of a point; it decides how serious a fault there is.
enum class Place {
    ordinary,         ///< any picture may show it
    rough,            ///< likewise, on a map of random texels: tilts may be extreme
    visibleMeridian,  ///< x or y is exactly the eye's: a picture of odd size shows it
    hiddenMeridian,   ///< x, y or z is exactly the centre's, on a side that no usual picture shows
    nearestPoint,  ///< nearest to the eye: a pole in some readings; a picture of odd size shows it
    pole,          ///< at a pole of some polar coordinates, or within rounding of one
    tinyMap        ///< an ordinary point of a map of 4 x 4 texels
};

/// Questions at special points, and the kind of the points of all other questions.
struct ConductPlan {
    std::size_t visibleMeridian = 0;
    std::size_t hiddenMeridian = 0;
    std::size_t nearestPoint = 0;
    std::size_t lastRows = 0;
    std::size_t poles = 0;
    std::size_t smallMap = 0;
    std::size_t tinyMap = 0;
    std::vector<std::size_t> rough;  ///< the maps of random texels of other plans
    std::size_t twice = 0;  ///< a flat map, at some points and then at the same points again
    /// Questions that follow one about another map of the same size, at one point. Each has four
    /// points: that point, one far from it, one mostly in the same texel, and that point again.
    std::vector<std::size_t> afterOtherMap;

    [[nodiscard]] Place placeOf(std::size_t question) const;
};

[[nodiscard]] ConductPlan planConduct(Questionnaire& questionnaire, Draws& draws);

/// A fault at some points: their number and the first of them.
struct Offence {
    double count = 0.0;
    double asked = 0.0;
    std::string message;  ///< of the first exception from the student's code
    Vector3 direction;    ///< of the first such point, from the centre
    int width = 0;        ///< of the map at the first such point
    int height = 0;
    double value = 0.0;  ///< the largest error, if the fault has a size

    [[nodiscard]] explicit operator bool() const { return count > 0.0; }
};

/// Faults that do not depend on the meaning of the normals.
struct Conduct {
    Offence threw;        ///< at points that a picture may show
    Offence threwHidden;  ///< at poles, hidden meridians, or on the tiny map
    Offence notFinite;    ///< at points that a picture may show
    Offence notFiniteHidden;
    Offence notUnit;
    Offence notUnitHidden;
    Offence inward;            ///< the normal points into the sphere
    Offence missing;           ///< not answered, though the process ended properly
    double largestTilt = 0.0;  ///< over all ordinary points, and those on rough maps
    double chance = 0.0;       ///< median change of the normal when a point is asked for again
    /// Largest change of a normal caused by what was asked just before it: the same point of
    /// another map, or another point of the same map, or of the same texel.
    double memory = 0.0;
    /// Two maps of random texels gave the very same normals, at all points asked for.
    bool sameOnOtherMap = false;
};

[[nodiscard]] Conduct readConduct(const ConductPlan& plan, const Answers& answers);

}  // namespace ticker::tasks::bump

#endif
