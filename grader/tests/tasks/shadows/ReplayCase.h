#ifndef TICKER_TESTS_TASKS_SHADOWS_REPLAYCASE_H
#define TICKER_TESTS_TASKS_SHADOWS_REPLAYCASE_H

#include <grader/tasks/shadows/answers/ShadowReplay.h>

#include <numbers>
#include <vector>

namespace ticker::tasks {

/// A point of a floor under a light. A sphere hides half of the light: rays to negative x arrive.
struct ReplayCase {
    ShadowQuestion question;
    ShadowLog log;

    ReplayCase() {
        raytracer::SceneDescription& scene = question.question.scene;
        scene.ambientLighting = raytracer::ColourRGB{0.1, 0.2, 0.3};
        scene.pointLights.emplace_back(Vector3{0.0, 4.0, 0.0}, raytracer::ColourRGB{0.5, 0.6, 0.7},
                                       64.0 * std::numbers::pi);
        raytracer::Material material;
        material.colour = raytracer::ColourRGB{0.9, 0.5, 0.2};
        scene.spheres.push_back({{0.3, 2.0, 0.0}, 0.3, material, nullptr});
        scene.planes.push_back({{}, {0.0, 1.0, 0.0}, material});
        question.zones = {{Zone::penumbra}};
        question.question.points = {{1, {}, {0.0, 1.0, 0.0}, {0.0, 3.0, 0.0}}};
    }

    ~ReplayCase() = default;
    ReplayCase(const ReplayCase& other) : question(other.question), log(other.log) {
        log.asked = &question;
    }
    ReplayCase& operator=(const ReplayCase&) = delete;

    /// Asks with rays to these x at the light's height, and answers with this colour.
    void answer(const std::vector<double>& aims, const ColourRGB& colour) {
        probe::IlluminateAnswer given;
        given.state = probe::AnswerState::answered;
        given.colours = {colour};
        for (const double x : aims) {
            probe::Event event;
            event.kind = probe::Event::Kind::rayCast;
            event.a = {0.0, 1e-4, 0.0};
            event.b = Vector3{x, 4.0, 0.0} * 0.37;
            given.events.push_back(event);
        }
        log = readShadowLog(question, given);
    }
    [[nodiscard]] bool fitsAs(ShadowArithmetic arithmetic) const {
        return fits(log.points[0], log.scene(), log.settings(), {}, arithmetic);
    }
};

// By hand: the light's distance is 4, so that its colour arrives as it is (64 pi / (4 pi 16) = 1);
// N.L = 1 and R.V = 1.
inline const ColourRGB kAmbient{0.09, 0.1, 0.06};
inline const ColourRGB kDiffuse{0.9 * 0.5 * 0.8, 0.5 * 0.6 * 0.8, 0.2 * 0.7 * 0.8};
inline const ColourRGB kSpecular{0.25 * 1.2, 0.36 * 1.2, 0.49 * 1.2};

}  // namespace ticker::tasks

#endif
