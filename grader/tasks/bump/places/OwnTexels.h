#ifndef TICKER_TASKS_BUMP_PLACES_OWNTEXELS_H
#define TICKER_TASKS_BUMP_PLACES_OWNTEXELS_H

#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/answers/Response.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <vector>

namespace ticker::tasks::bump {

/// A map of random texels: the slopes of one column, or row, say nothing about those of another.
struct OwnTexelPlan {
    std::vector<Vector3> directions;
    LevelPair noise;
};

[[nodiscard]] OwnTexelPlan planOwnTexels(Questionnaire& questionnaire, Draws& draws,
                                         const Ball& ball);

/// The column, or row, two or more away from the point's own that explains the most of the tilts:
/// the sum of its texels' squared correlations with them.
struct FarLine {
    double share = 0.0;
    int away = 0;  ///< columns or rows; positive where u or v grows

    /// Accepted readings look up the point's own line or one beside it. Another one's texels are
    /// independent of their tilts, so that each squared correlation is about 1 / n for n texels
    /// that count, at least 600 of them. Tilts of neighbours share texels, which weighs the nine by
    /// 2.5 at most (bilinear central differences): their sum is below three times chi-squared with
    /// three degrees of freedom over n. One of 30 lines exceeds the limit once in 10^9 times even
    /// if n is 310. The accepted readings have at most 0.072, under two seeds; code that looks
    /// there and rounds down, 0.88 and more.
    [[nodiscard]] bool good() const { return share <= 0.5; }
};

struct OwnTexels {
    FarLine row;     ///< for slopes along u
    FarLine column;  ///< for slopes along v

    [[nodiscard]] bool good() const { return row.good() && column.good(); }
};

[[nodiscard]] OwnTexels readOwnTexels(const OwnTexelPlan& plan, const Answers& answers,
                                      const Parametrisation& parametrisation,
                                      const Response& response);

}  // namespace ticker::tasks::bump

#endif
