#ifndef TICKER_TASKS_DISTRIBUTED_SHADOWLOG_H
#define TICKER_TASKS_DISTRIBUTED_SHADOWLOG_H

#include <grader/probe/Question.h>
#include <grader/tasks/shadows/questions/ShadowQuestions.h>
#include <grader/tasks/support/Surfaces.h>

#include <cstddef>
#include <vector>

namespace ticker::tasks {

/// One logged shadow ray. Only its line can be seen: how long the student's direction was says
/// nothing about where on the line the sample lies.
struct AimLine {
    Vector3 origin;
    Vector3 direction;                ///< unit
    Vector3 foot;                     ///< from the light's centre to the line's nearest point
    double miss = 0.0;                ///< length of `foot`
    Sight toLight = Sight::unsure;    ///< to the light: what stands behind it does not count
    Sight endlessly = Sight::unsure;  ///< anything on the line counts
};

/// What `illuminate` did at one point.
struct PointLog {
    probe::LitPoint point;
    ColourRGB colour;
    std::vector<std::vector<AimLine>> lines;  ///< for each light, in the order of casting
    std::vector<Zone> zones;                  ///< for each light

    [[nodiscard]] std::size_t lineCount() const;
};

/// Everything about one answered question.
struct ShadowLog {
    const ShadowQuestion* asked = nullptr;
    std::vector<PointLog> points;
    bool cut = false;  ///< more rays than the log had room for: counts are lower bounds

    [[nodiscard]] const raytracer::SceneDescription& scene() const { return asked->question.scene; }
    [[nodiscard]] const raytracer::RenderSettings& settings() const {
        return asked->question.settings;
    }
};

/// Sorts the logged rays by point and by light: each belongs to the light that it passes at the
/// smallest angle. `asked` must live as long as the log.
[[nodiscard]] ShadowLog readShadowLog(const ShadowQuestion& asked,
                                      const probe::IlluminateAnswer& answer);

}  // namespace ticker::tasks

#endif
