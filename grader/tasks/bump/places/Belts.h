#ifndef TICKER_TASKS_BUMP_PLACES_BELTS_H
#define TICKER_TASKS_BUMP_PLACES_BELTS_H

#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/answers/Response.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <array>
#include <cstddef>
#include <vector>

namespace ticker::tasks::bump {

/// Points beside the three coordinate planes through the sphere's centre: there one coordinate is
/// nearly 0, and code that is afraid of a division by 0 may take another place of the map. Asked on
/// three maps of one wave along each axis, which are a sixth of a period apart.
struct BeltPlan {
    struct Wave {
        std::size_t question = 0;
        double phaseU = 0.0;  ///< radians
        double phaseV = 0.0;
    };
    std::vector<Vector3> directions;  ///< beside x = 0, y = 0, z = 0 in turn, as `beltOf` says
    std::size_t flat = 0;
    std::array<Wave, 3> waves;
};

[[nodiscard]] BeltPlan planBelts(Questionnaire& questionnaire, Draws& draws, const Ball& ball);

/// Share of the points that lean to the wrong side along one axis of the map, in the quarter of a
/// belt where most do. Only points on steep parts of the wave count, two or all of the three maps
/// at any place, so that a place that is wrong by a twentieth of the map gives 0. A place that is
/// wrong by a quarter of the map gives a third or more, one that is wrong by half of it gives 1. An
/// axis along which bumps tilt less than a two-hundredth as far as along the other is not judged.
struct Belts {
    double wrong = 0.0;
    char plane = 'x';  ///< of which coordinate

    [[nodiscard]] bool good() const { return wrong <= 0.2; }
};

[[nodiscard]] Belts readBelts(const BeltPlan& plan, const Answers& answers,
                              const Parametrisation& parametrisation, const Response& response);

}  // namespace ticker::tasks::bump

#endif
