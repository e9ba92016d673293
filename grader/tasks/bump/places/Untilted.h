#ifndef TICKER_TASKS_BUMP_PLACES_UNTILTED_H
#define TICKER_TASKS_BUMP_PLACES_UNTILTED_H

#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <array>
#include <cstdint>

namespace ticker::tasks::bump {

/// Where a condition of the code's own may keep the normal smooth although the map is rough.
enum class Whereabouts : std::uint8_t {
    nearPoles,    ///< 2.3 to 5.5 degrees from either end of each axis
    atRim,        ///< where the eye sees the sphere nearly edge-on
    farAway,      ///< a sphere some 180 from the eye
    smallSphere,  ///< of radius 0.05
    onBlack,      ///< texels of height 0 beside higher ones
    fewRows,      ///< some row of a map of 5 rows
    fewColumns,   ///< some column of a map of 5 columns
    onDiagonals,  ///< where both slopes are equal, or opposite
    evenSteps,    ///< texels are equal in pairs, 0 and 1, 2 and 3
    oddSteps      ///< 1 and 2, 3 and 4
};
inline constexpr std::size_t kWhereabouts = 10;

/// A rough map on these spheres, and at these points.
struct UntiltedPlan {
    std::array<LevelPair, kWhereabouts> pairs;

    [[nodiscard]] const LevelPair& at(Whereabouts where) const {
        return pairs.at(static_cast<std::size_t>(where));
    }
};

[[nodiscard]] UntiltedPlan planUntilted(Questionnaire& questionnaire, Draws& draws,
                                        const Ball& ball);

/// The share of the points whose normal is the smooth one; near the poles, of the axis that has the
/// most. Neighbouring texels of the rough map are equal once in 256 times, so that code without
/// such a condition gives 0.02 at most; of the map that is black in one of three texels, where the
/// gentler of two differences is taken, 0.1, with a standard deviation of 0.013. A condition that
/// holds at all of these points gives 1, on black 0.33 and more, at the rim, where half of the
/// tilted normals face away, 0.3 and more. On few rows or columns, neighbours are never equal: code
/// whose slopes are 0 at the map's edges gives 0.024, the corners; a row or a column that is left
/// out 0.095 and more.
/// Along both diagonals, central differences are 0 at one of seven texels, and a condition on one
/// of the diagonals gives 0.43. Where texels are equal in pairs, the two kinds of pairs are
/// compared: differences to one side are 0 at a half of the texels of either, the gentler of two at
/// all of either. Code that reads every other column gives 0.75 and 0.25, with a standard deviation
/// of 0.02.
struct Untilted {
    std::array<double, kWhereabouts> shares{};

    [[nodiscard]] bool good(Whereabouts where) const;
    [[nodiscard]] bool good() const;
};

[[nodiscard]] Untilted readUntilted(const UntiltedPlan& plan, const Answers& answers);

}  // namespace ticker::tasks::bump

#endif
