#ifndef TICKER_TESTS_TASKS_SHADOWS_SHADOWBYHAND_H
#define TICKER_TESTS_TASKS_SHADOWS_SHADOWBYHAND_H

#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tests/tasks/support/InFinding.h>

#include <cmath>
#include <deque>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace ticker::tasks {

/// Logs of shadow rays that tests fill themselves: points of a floor (y = 0) under lights.
class ShadowByHand {
public:
    using Purpose = ShadowQuestion::Purpose;

    ShadowByHand() = default;
    ~ShadowByHand() = default;
    ShadowByHand(const ShadowByHand&) = delete;
    ShadowByHand& operator=(const ShadowByHand&) = delete;

    /// Another question, with a light at each of these places.
    ShadowQuestion& ask(Purpose purpose, const std::vector<Vector3>& lights = {{0.0, 6.0, 0.0}}) {
        ShadowQuestion& question = questions_.emplace_back();
        question.purpose = purpose;
        for (const Vector3& light : lights)
            question.question.scene.pointLights.emplace_back(light, ColourRGB{1.0}, 400.0);
        question.question.scene.planes.push_back({{}, {0.0, 1.0, 0.0}, {}});
        logs_.emplace_back();
        logs_.back().asked = &question;
        return question;
    }
    /// Another point of the last question, with no rays yet.
    PointLog& point(const Vector3& position = {}, const Vector3& normal = {0.0, 1.0, 0.0}) {
        PointLog& point = logs_.back().points.emplace_back();
        point.point = {0, position, normal, {0.0, 3.0, -1.0}};
        point.lines.resize(logs_.back().scene().pointLights.size());
        point.zones.assign(point.lines.size(), Zone::lit);
        return point;
    }
    /// A ray to `aim` from beside the last point.
    AimLine& cast(const Vector3& aim, std::size_t light = 0,
                  const Vector3& bias = {0.0, 1e-4, 0.0}) {
        PointLog& point = logs_.back().points.back();
        AimLine line;
        line.origin = point.point.position + bias;
        line.direction = (aim - line.origin).normalised();
        const Vector3 between = logs_.back().scene().pointLights[light].position() - line.origin;
        line.foot = line.direction * between.dot(line.direction) - between;
        line.miss = line.foot.magnitude();
        line.toLight = line.endlessly = Sight::open;
        return point.lines[light].emplace_back(line);
    }
    /// Rays to aims on an arc round the light's centre, 0.1 radians from one to the next, at the
    /// distance `off` from the centre. The default is half of the handout's radius.
    void castArc(int rays, std::size_t light = 0, double off = 0.2) {
        const Vector3 centre = logs_.back().scene().pointLights[light].position();
        for (int i = 0; i < rays; ++i)
            cast(centre + Vector3{off * std::cos(0.1 * i), 0.0, off * std::sin(0.1 * i)}, light);
    }
    [[nodiscard]] ShadowLogs logs() const { return ShadowLogs{logs_}; }
    [[nodiscard]] ShadowLog& last() { return logs_.back(); }

private:
    std::deque<ShadowQuestion> questions_;
    std::vector<ShadowLog> logs_;
};

}  // namespace ticker::tasks

#endif
