#ifndef TICKER_TASKS_BUMP_CONDUCT_H
#define TICKER_TASKS_BUMP_CONDUCT_H

#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ticker::tasks::bump {

/// What a fault at a point means.
enum class Place {
    ordinary,         ///< any picture may show it
    rough,            ///< likewise, on a map of random texels: tilts may be extreme
    visibleMeridian,  ///< x or y is exactly that of the eye: a picture of odd size shows it
    hiddenMeridian,   ///< x, y or z is exactly the centre's, on a side that no usual picture shows
    nearestPoint,     ///< nearest to the eye: a pole for some, yet a picture of odd size shows it
    pole,             ///< at, or within rounding of, a place where polar coordinates end
    tinyMap           ///< an ordinary point of a map of 4 x 4 texels
};

/// Questions at special points, and where every other question's points lie.
struct ConductPlan {
    std::size_t visibleMeridian = 0;
    std::size_t hiddenMeridian = 0;
    std::size_t nearestPoint = 0;
    std::size_t lastRows = 0;
    std::size_t poles = 0;
    std::size_t smallMap = 0;
    std::size_t tinyMap = 0;
    std::optional<std::size_t> steep;  ///< random texels of another part of the examination
    std::size_t twice = 0;  ///< a flat map, at some points and then at the same ones again
    /// A point of another map of the same size was asked for just before: this point, one far from
    /// it, and this point again.
    std::vector<std::size_t> afterOtherMap;

    [[nodiscard]] Place placeOf(std::size_t question) const;
};

[[nodiscard]] ConductPlan planConduct(Questionnaire& questionnaire, Draws& draws);

/// Something that went wrong at some points: how many of how many, and where for the first time.
struct Offence {
    double count = 0.0;
    double asked = 0.0;
    std::string message;  ///< of the first exception; what the student's code said
    Vector3 direction;    ///< of the first point, from the centre
    int width = 0;        ///< of the first point's map
    int height = 0;
    double value = 0.0;  ///< the largest error, where there is one

    [[nodiscard]] explicit operator bool() const { return count > 0.0; }
};

/// How the code behaved, whatever its normals mean.
struct Conduct {
    Offence threw;        ///< at points that a picture may show
    Offence threwHidden;  ///< at poles, hidden meridians, or on the tiny map
    Offence notFinite;    ///< at points that a picture may show
    Offence notFiniteHidden;
    Offence notUnit;
    Offence notUnitHidden;
    Offence inward;            ///< the normal points into the sphere
    Offence missing;           ///< never answered, though the process ended well
    double largestTilt = 0.0;  ///< over all ordinary points and maps
    double chance = 0.0;       ///< median change of the normal where a point is asked for again
    /// Largest change of a normal by what was asked just before: the same point on another map, or
    /// another point on this one.
    double memory = 0.0;
};

[[nodiscard]] Conduct readConduct(const ConductPlan& plan, const Answers& answers);

}  // namespace ticker::tasks::bump

#endif
