#ifndef TICKER_TASKS_BUMP_PLACES_FEWTEXELS_H
#define TICKER_TASKS_BUMP_PLACES_FEWTEXELS_H

#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <vector>

namespace ticker::tasks::bump {

/// Chords over three of 24 columns already turn by 45 degrees; those over rows stay in one plane,
/// so that fewer rows will do.
inline constexpr int kFewColumns = 24;
inline constexpr int kFewRows = 12;

/// A map of few columns that vary along u alone, and one of few rows that vary along v alone: one
/// wave from edge to edge, high at both. The texels are so large that those next to the outermost
/// ones show. Two more maps are flat but for two higher columns (on the other map, rows): the last
/// one and one in the middle.
struct FewTexelPlan {
    std::vector<Vector3> directions;
    LevelPair columns;
    LevelPair rows;
    std::size_t columnRidges = 0;
    std::size_t rowRidges = 0;
};

[[nodiscard]] FewTexelPlan planFewTexels(Questionnaire& questionnaire, Draws& draws,
                                         const Ball& ball);

/// Share of the points that tilt towards where the wave falls, in the second texel or in the last
/// but one, whichever share is smaller. The rule beyond the map's edge does not matter there. The
/// direct neighbours lie in the map, and the wave falls the same way even for differences over
/// three texels that wrap, clamp or mirror. A test holds accepted readings to 0.8, since chords
/// over three columns bend. Code whose neighbour stops one texel too early gives 0.
struct FewTexels {
    double alongU = 1.0;
    double alongV = 1.0;
    /// The same share inside the map. Differences over a step of u or v that is shorter than a
    /// texel, such as 0.01, are 0 nearly everywhere if each height is that of the nearest texel.
    double insideU = 1.0;
    double insideV = 1.0;
    /// On the map that varies along v alone: the tilts along u in the first or the last column,
    /// divided by those along v, whichever is larger. Right code gives nearly 0. Code that takes
    /// the neighbour beyond the last column from another row gives 1.
    double aside = 0.0;

    /// Share of the points before the higher last column, or row, that lean away from it, divided
    /// by that before the one in the middle. Right code gives about 1: both ridges stand inside the
    /// map. Wide differences that mirror at the edge give 0.37 at least. Code that wraps one texel
    /// too early, by (column + 1) % (width() - 1), gives 0.
    double beforeLastColumn = 1.0;
    double beforeLastRow = 1.0;

    /// On the map that varies along u alone: share of the points in the outer half of the first or
    /// the last column, whichever is larger, that tilt nearly as much as where the wave is
    /// steepest. The wave is level there, and right code gives 0. Code that takes a column far away
    /// from the seam gives 1.
    double steepAtSeam = 0.0;

    static constexpr double kLeast = 0.6;
    static constexpr double kLeastBeforeLast = 0.12;
    [[nodiscard]] bool goodU() const {
        return alongU >= kLeast && beforeLastColumn >= kLeastBeforeLast;
    }
    [[nodiscard]] bool goodV() const {
        return alongV >= kLeast && beforeLastRow >= kLeastBeforeLast;
    }
    static constexpr double kMostAside = 0.5;
    [[nodiscard]] bool goodAside() const { return aside <= kMostAside; }
    static constexpr double kMostSteep = 0.5;
    [[nodiscard]] bool goodSeam() const { return steepAtSeam <= kMostSteep; }
    [[nodiscard]] bool good() const { return goodU() && goodV() && goodAside() && goodSeam(); }
};

[[nodiscard]] FewTexels readFewTexels(const FewTexelPlan& plan, const Answers& answers,
                                      const Parametrisation& parametrisation);

}  // namespace ticker::tasks::bump

#endif
