#ifndef TICKER_TASKS_SHADOWS_ANSWERS_SHADOWLOG_H
#define TICKER_TASKS_SHADOWS_ANSWERS_SHADOWLOG_H

#include <grader/probe/Question.h>
#include <grader/tasks/shadows/questions/ShadowQuestions.h>
#include <grader/tasks/support/Surfaces.h>

#include <cstddef>
#include <vector>

namespace ticker::tasks {

/// One logged shadow ray. Only its line is visible: the length of the student's direction does not
/// say where on the line the sample lies.
struct AimLine {
    Vector3 origin;
    Vector3 direction;                ///< unit
    Vector3 foot;                     ///< from the light's centre to the line's nearest point
    double miss = 0.0;                ///< length of `foot`
    Sight toLight = Sight::unsure;    ///< up to the light
    Sight endlessly = Sight::unsure;  ///< whole ray: objects behind the light count
    bool isReversed = false;          ///< was cast from the light to the point
    bool isAdded = false;  ///< was not logged: `withCachedRays` takes it for cast and blocked
};

/// Whether a surface surely lies between the ray's start and the light.
[[nodiscard]] inline bool isBlocked(const AimLine& line) {
    return line.toLight == Sight::blocked;
}

/// What `illuminate` did at one point.
struct PointLog {
    probe::LitPoint point;
    ColourRGB colour;
    std::vector<std::vector<AimLine>> lines;  ///< for each light, in the order of casting
    std::vector<Zone> zones;                  ///< for each light

    [[nodiscard]] std::size_t lineCount() const;
};

/// The points of one answered question.
struct ShadowLog {
    const ShadowQuestion* asked = nullptr;
    std::vector<PointLog> points;
    bool cut = false;  ///< more rays than the log holds: counts are lower bounds

    [[nodiscard]] const raytracer::SceneDescription& scene() const { return asked->question.scene; }
    [[nodiscard]] const raytracer::RenderSettings& settings() const {
        return asked->question.settings;
    }
};

/// Sorts the logged rays by point and by light: a ray belongs to the light that it passes at the
/// smallest angle. `asked` must outlive the log.
[[nodiscard]] ShadowLog readShadowLog(const ShadowQuestion& asked,
                                      const probe::IlluminateAnswer& answer);

}  // namespace ticker::tasks

#endif
