#ifndef TICKER_TASKS_BUMP_LETTERS_H
#define TICKER_TASKS_BUMP_LETTERS_H

#include <grader/result/Finding.h>
#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/answers/Response.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <cstddef>
#include <string>
#include <vector>

namespace ticker::tasks::bump {

/// The handout's own test: a map of bright letters H and dark letters L on grey, asked for on a
/// grid over the near side of the scene's sphere.
struct LetterPlan {
    static constexpr int kColumns = 128;  ///< from about -88 to 88 degrees of longitude
    static constexpr int kRows = 64;      ///< from about 44 degrees above the equator to 44 below

    std::vector<Vector3> directions;  ///< row after row from the top
    std::size_t flat = 0;             ///< of the same size, at the same points
    std::size_t question = 0;
};

[[nodiscard]] LetterPlan planLetters(Questionnaire& questionnaire, Draws& draws);

/// Paths over one kind of letter's edges, and whether the recovered height changed the right way.
struct EdgeCount {
    int right = 0;
    int opposite = 0;
    int lost = 0;  ///< hardly any change

    [[nodiscard]] int crossed() const { return right + opposite + lost; }
    /// Hardly any opposite change, and a change at half the edges: a coarse sampling of a steep
    /// edge may miss it.
    [[nodiscard]] bool mostlyRight() const {
        return 9 * opposite <= right && 2 * right >= crossed() && right > 0;
    }
    [[nodiscard]] bool mostlyOpposite() const {
        return 9 * right <= opposite && 2 * opposite >= crossed() && opposite > 0;
    }
};

/// One kind of letter: what its vertical strokes' edges say (crossed along u) and what its
/// horizontal ones say (crossed along v).
struct LetterCount {
    EdgeCount alongU;
    EdgeCount alongV;
};

struct LetterReading {
    LetterCount h;
    LetterCount l;

    [[nodiscard]] bool good() const;
};

/// "raised", "lowered", "half" or "unclear": how a letter looks that should be raised, or (with
/// `lowered` true) lowered.
[[nodiscard]] std::string look(const LetterCount& count, bool lowered);

/// The recovered height differences along the grid, and those of the map.
[[nodiscard]] LetterReading readLetters(const LetterPlan& plan, const Answers& answers,
                                        const Parametrisation& parametrisation,
                                        const Response& response);

/// Two pictures of the near side: the map where this submission lays it, and the relief that its
/// normals show.
[[nodiscard]] std::vector<Raster> drawRelief(const LetterPlan& plan, const Answers& answers,
                                             const Parametrisation& parametrisation,
                                             const Response& response);

}  // namespace ticker::tasks::bump

#endif
