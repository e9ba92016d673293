#ifndef TICKER_TESTS_MAINTICK_RIGHTANSWERS_H
#define TICKER_TESTS_MAINTICK_RIGHTANSWERS_H

#include <grader/probe/Examinee.h>
#include <grader/tasks/maintick/mixed/MirrorLinks.h>
#include <grader/tasks/support/Surfaces.h>

#include <variant>
#include <vector>

namespace ticker::tasks {

/// The answer of right code to a question about points, shadows included.
[[nodiscard]] inline probe::Answer rightAnswer(const probe::IlluminateQuestion& asked) {
    probe::IlluminateAnswer answer;
    answer.state = probe::AnswerState::answered;
    std::vector<maintick::MirrorLink> links;
    for (const probe::LitPoint& point : asked.points)
        links.push_back({point.object, 0.0, point.position, point.normal, point.viewer});
    answer.colours = maintick::directOf(asked.scene, links);
    return answer;
}

[[nodiscard]] inline ColourRGB tracedRightly(const raytracer::SceneDescription& scene,
                                             const raytracer::Ray& ray, int bounces) {
    const auto links = maintick::linksOf(scene, ray, {});
    if (links.empty()) return kBackground;
    const double share = links[0].share;
    const ColourRGB own = maintick::directOf(scene, {links[0]})[0];
    if (bounces == 0 || share == 0.0) return own;
    const raytracer::Ray next{links[0].P + links[0].N * 1e-4,
                              (-ray.direction).reflectIn(links[0].N)};
    return own * (1.0 - share) + tracedRightly(scene, next, bounces - 1) * share;
}

/// The answer of right code to a question about rays.
[[nodiscard]] inline probe::Answer rightAnswer(const probe::TraceQuestion& asked) {
    probe::IlluminateAnswer answer;
    answer.state = probe::AnswerState::answered;
    for (const probe::CastRay& cast : asked.rays)
        answer.colours.push_back(
            tracedRightly(asked.scene, {cast.origin, cast.direction}, cast.bounces));
    return answer;
}

[[nodiscard]] inline probe::Answer rightAnswer(const probe::Question& question) {
    if (const auto* points = std::get_if<probe::IlluminateQuestion>(&question))
        return rightAnswer(*points);
    return rightAnswer(std::get<probe::TraceQuestion>(question));
}

}  // namespace ticker::tasks

#endif
