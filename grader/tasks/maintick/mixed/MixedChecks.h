#ifndef TICKER_TASKS_MAINTICK_MIXED_MIXEDCHECKS_H
#define TICKER_TASKS_MAINTICK_MIXED_MIXEDCHECKS_H

#include <grader/probe/Examinee.h>
#include <grader/result/SubmissionResult.h>
#include <grader/tasks/maintick/mixed/MixedMirrors.h>
#include <grader/tasks/maintick/mixed/MixedPoints.h>
#include <grader/tasks/maintick/mixed/MixedShades.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ticker::tasks::maintick {

// Each `ask` appends questions, and the `check` of the same name judges the answers to them. They
// are judged where the other questions of the task found nothing.

void askMixedPoints(const std::vector<MixedPoint>& points, std::vector<probe::Question>& questions);
/// A light that code loses only beside other objects is a mistake of M3.2.
[[nodiscard]] std::optional<Finding> checkMixedPoints(const std::vector<MixedPoint>& points,
                                                      std::span<const probe::Answer> answers);

void askMixedShades(const std::vector<MixedShade>& shades, std::vector<probe::Question>& questions);
/// Compares with what the same code gives for the point alone, without the lights that are hidden.
[[nodiscard]] std::optional<Finding> checkMixedShades(const std::vector<MixedShade>& shades,
                                                      std::span<const probe::Answer> answers);

void askMixedMirrors(const std::vector<MixedMirror>& mirrors,
                     std::vector<probe::Question>& questions);
/// Compares with what the same code's `illuminate` gives for each surface. A ray is not judged if
/// that changes within a thousandth of the surface, as it does for shadows without a bias.
[[nodiscard]] std::optional<Finding> checkMixedMirrors(const std::vector<MixedMirror>& mirrors,
                                                       std::span<const probe::Answer> answers);

/// A hint for what goes wrong in some scenes alone. `usual` is what the handout says.
[[nodiscard]] inline std::string hintFor(const char* commonWords, const std::string& usual) {
    if (commonWords == nullptr)
        return usual +
               " It is right in ordinary scenes: look for a condition or a limit in your "
               "code that the handout does not have.";
    return "It is right in other scenes and wrong where there is " + std::string{commonWords} +
           ": look for a condition or a limit in your code that the handout does not have. " +
           usual;
}

}  // namespace ticker::tasks::maintick

#endif
