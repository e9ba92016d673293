#ifndef TICKER_TASKS_BUMP_PLACES_CAPS_H
#define TICKER_TASKS_BUMP_PLACES_CAPS_H

#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <vector>

namespace ticker::tasks::bump {

/// Ramps with heights in whole bytes, along u and along v, asked on rings round both ends of each
/// axis. Other questions about directions leave out points within 11 degrees of the poles. The ramp
/// along v rises near both ends and falls in between.
struct CapPlan {
    std::vector<Vector3> directions;  ///< group after group: axis by axis, end by end, ring by ring
    LevelPair columns;
    LevelPair rows;
};

[[nodiscard]] CapPlan planCaps(Questionnaire& questionnaire, Draws& draws, const Ball& ball);

/// Share of the tilted points whose tilt leads within 60 degrees of where the ramp falls, in the
/// worst of four groups: inner or outer ring at either end of the map's axis. A test holds accepted
/// readings to 0.9: the direction is that of one tangent, whatever the gain. Tangents that do not
/// turn with the longitude give 0.33, rows that stop before the poles give 0 along v.
struct Caps {
    double alongU = 1.0;
    double alongV = 1.0;

    static constexpr double kLeast = 0.7;
    [[nodiscard]] bool goodU() const { return alongU >= kLeast; }
    [[nodiscard]] bool goodV() const { return alongV >= kLeast; }
    [[nodiscard]] bool good() const { return goodU() && goodV(); }
};

/// A share is 1 if the question does not apply: the map's poles lie on no axis of space. Groups of
/// which more than half is not tilted are left out.
[[nodiscard]] Caps readCaps(const CapPlan& plan, const Answers& answers,
                            const Parametrisation& parametrisation);

}  // namespace ticker::tasks::bump

#endif
