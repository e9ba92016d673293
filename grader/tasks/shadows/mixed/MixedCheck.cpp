#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/answers/KnownColours.h>
#include <grader/tasks/shadows/mixed/MixedCheck.h>
#include <grader/tasks/shadows/mixed/ShadowTraits.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <vector>

namespace ticker::tasks {
namespace {

/// All points of the logs, and which of them have a wrong colour.
struct Judged {
    std::vector<PointOfLog> points;
    std::vector<bool> isWrong;
};

/// The readings under which code with this reading is judged. Only the central reading gives exact
/// colours. The others give intervals that may fit by chance, so that all accepted ones are tried.
std::vector<ShadowReading> readingsLike(const ShadowReading& reading) {
    if (reading.phong == ShadowReading::Phong::central) return {reading};
    return acceptedShadowReadings();
}

/// A point is right if its colour is near what geometry tells and fits a reading; a reading fits
/// any colour of a point without rays. If each point of a log is right, but no single reading fits
/// all of them, all count as wrong.
Judged judged(const std::vector<const ShadowLog*>& logs, const ShadowReading& found,
              bool raysSeen) {
    const std::vector<ShadowReading> readings = readingsLike(found);
    Judged all;
    for (const ShadowLog* log : logs) {
        const bool isOneReading =
            !raysSeen || std::ranges::any_of(readings, [&](const ShadowReading& reading) {
                return allFit(*log, reading, ShadowArithmetic::right);
            });
        const auto isRight = [&](const PointLog& point) {
            const auto fitsPoint = [&](const ShadowReading& reading) {
                return fits(point, log->scene(), log->settings(), reading, ShadowArithmetic::right);
            };
            return isNearKnown(point, *log, found.viewerIsEye) &&
                   (isOneReading || std::ranges::any_of(readings, fitsPoint));
        };
        const bool areAllWrong = !isOneReading && std::ranges::all_of(log->points, isRight);
        for (const PointLog& point : log->points) {
            all.points.push_back({log, &point});
            all.isWrong.push_back(areAllWrong || !isRight(point));
        }
    }
    return all;
}

}  // namespace

std::optional<Finding> checkMixed(const std::vector<const ShadowLog*>& logs,
                                  const ShadowReading& reading, bool raysSeen) {
    const Judged all = judged(logs, reading, raysSeen);
    const auto wrong = std::ranges::count(all.isWrong, true);
    if (wrong == 0) return std::nullopt;
    const PointTrait* common = commonTrait(pointTraits(), all.points, all.isWrong);
    Finding finding = distributedFinding(
        kShadowWrong, Severity::fail,
        fmt::format("In usual scenes the colours are right; in scenes with unusual lights, "
                    "materials and places the colour is another one than expected at {} of {} "
                    "points.{}",
                    wrong, all.points.size(),
                    common == nullptr
                        ? ""
                        : fmt::format(" All of these have in common that {}.", common->words)));
    finding.hint = common != nullptr && *common->hint != '\0'
                       ? common->hint
                       : "illuminate treats every light, surface and place in the same way: leave "
                         "out limits and special cases of your own.";
    finding.section = "Soft shadows (T2.1), step 3";
    finding.evidence.emplace_back("wrongPoints", static_cast<double>(wrong));
    finding.evidence.emplace_back("points", static_cast<double>(all.points.size()));
    return finding;
}

}  // namespace ticker::tasks
