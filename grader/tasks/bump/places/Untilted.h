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
    farAway,      ///< a sphere about 180 from the eye
    smallSphere,  ///< of radius 0.05
    onBlack,      ///< texels of height 0 beside higher ones
    fewRows,      ///< some row of a map of 5 rows
    fewColumns,   ///< some column of a map of 5 columns
    onDiagonals,  ///< where both slopes are equal, or opposite
    evenSteps,    ///< texels are equal in pairs, 0 and 1, 2 and 3
    oddSteps      ///< 1 and 2, 3 and 4
};
inline constexpr std::size_t kWhereabouts = 10;

/// Questions about a rough map, and about a flat one at the same points, for each of these.
struct UntiltedPlan {
    std::array<LevelPair, kWhereabouts> pairs;

    [[nodiscard]] const LevelPair& at(Whereabouts where) const {
        return pairs.at(static_cast<std::size_t>(where));
    }
};

[[nodiscard]] UntiltedPlan planUntilted(Questionnaire& questionnaire, Draws& draws,
                                        const Ball& ball);

/// Share of the points whose normal is the smooth one, for each place; near the poles, of the axis
/// that has the largest share. What right code and code with a condition of its own give:
///   rough map: neighbouring texels are equal once in 256 times, so that right code gives at most
///     0.02; a condition gives 1, or 0.3 and more at the rim, where half of the tilted normals face
///     away
///   onBlack: one texel of three is black; code that takes the gentler of two differences gives
///     0.1, with a standard deviation of 0.013, and a condition 0.33 and more
///   fewRows, fewColumns: neighbours are never equal; code whose slopes are 0 at the map's edges
///     gives 0.024, the corners, and code that leaves out a row or a column 0.095 and more
///   onDiagonals: central differences are 0 at one of seven texels; a condition on one of the
///     diagonals gives 0.43
///   evenSteps, oddSteps: these two are compared; differences to one side are 0 at half of the
///     texels of either, the gentler of two at all of either; code that reads every other column
///     gives 0.75 and 0.25, with a standard deviation of 0.02
struct Untilted {
    std::array<double, kWhereabouts> shares{};

    [[nodiscard]] bool good(Whereabouts where) const;
    [[nodiscard]] bool good() const;
};

[[nodiscard]] Untilted readUntilted(const UntiltedPlan& plan, const Answers& answers);

}  // namespace ticker::tasks::bump

#endif
