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

/// The handout's own test: a map of bright letters H and dark letters L on grey. Normals are asked
/// on a grid over the near side of the scene's sphere.
struct LetterPlan {
    static constexpr int kColumns = 128;  ///< from about -88 to 88 degrees of longitude
    static constexpr int kRows = 64;      ///< from about 44 degrees above the equator to 44 below

    std::vector<Vector3> directions;  ///< row after row from the top
    std::size_t flat = 0;             ///< flat map of the same size, at the same points
    std::size_t question = 0;
};

[[nodiscard]] LetterPlan planLetters(Questionnaire& questionnaire, Draws& draws);

/// How often the grid's rows or columns cross an edge of one kind of letter, by the change of the
/// recovered height there.
struct EdgeCount {
    int right = 0;
    int opposite = 0;
    int lost = 0;  ///< hardly any change

    [[nodiscard]] int crossed() const { return right + opposite + lost; }
    /// Hardly any opposite change, and the right change at half of the edges or more: a coarse
    /// sampling may miss a steep edge.
    [[nodiscard]] bool mostlyRight() const {
        return 9 * opposite <= right && 2 * right >= crossed() && right > 0;
    }
    [[nodiscard]] bool mostlyOpposite() const {
        return 9 * right <= opposite && 2 * opposite >= crossed() && opposite > 0;
    }
};

/// Edges of one kind of letter: those of its vertical strokes (crossed along u) and of its
/// horizontal strokes (crossed along v).
struct LetterCount {
    EdgeCount alongU;
    EdgeCount alongV;
};

struct LetterReading {
    LetterCount h;
    LetterCount l;

    [[nodiscard]] bool good() const;
};

/// How a letter looks: "raised", "lowered", "half" or "unclear".
/// @param lowered  True if the letter should be lowered.
[[nodiscard]] std::string look(const LetterCount& count, bool lowered);

/// Compares the recovered height differences along the grid with those of the map.
[[nodiscard]] LetterReading readLetters(const LetterPlan& plan, const Answers& answers,
                                        const Parametrisation& parametrisation,
                                        const Response& response);

/// Two pictures of the near side: the map as the submission lays it on the sphere, and the relief
/// recovered from its normals.
[[nodiscard]] std::vector<Raster> drawRelief(const LetterPlan& plan, const Answers& answers,
                                             const Parametrisation& parametrisation,
                                             const Response& response);

}  // namespace ticker::tasks::bump

#endif
