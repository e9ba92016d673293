#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/answers/KnownColours.h>
#include <grader/tasks/shadows/mixed/MixedCheck.h>
#include <grader/tasks/shadows/mixed/ShadowTraits.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <utility>

namespace ticker::tasks {
namespace {

struct Sorted {
    std::vector<PointOfLog> wrong;
    std::vector<PointOfLog> right;
};

/// Other readings than the central one compute with intervals, into which much fits.
std::vector<ShadowReading> readingsLike(const ShadowReading& reading) {
    if (reading.phong == ShadowReading::Phong::central) return {reading};
    return acceptedShadowReadings();
}

/// Any colour fits a point without rays, and the geometry says what is near it.
Sorted sorted(const std::vector<const ShadowLog*>& logs, const ShadowReading& found,
              bool raysSeen) {
    const std::vector<ShadowReading> readings = readingsLike(found);
    Sorted all;
    for (const ShadowLog* log : logs) {
        const auto fitsLog = [&](const ShadowReading& reading) {
            return allFit(*log, reading, ShadowArithmetic::right);
        };
        const bool isOneReading = !raysSeen || std::ranges::any_of(readings, fitsLog);
        std::vector<PointOfLog> some;
        for (const PointLog& point : log->points) {
            const auto fitsPoint = [&](const ShadowReading& reading) {
                return fits(point, log->scene(), log->settings(), reading, ShadowArithmetic::right);
            };
            const bool isRight = isNearKnown(point, *log, found.viewerIsEye) &&
                                 (isOneReading || std::ranges::any_of(readings, fitsPoint));
            (isRight ? some : all.wrong).push_back({log, &point});
        }
        // Each point fits a reading, and no reading fits all of them.
        const bool isMixed = !isOneReading && some.size() == log->points.size();
        auto& list = isMixed ? all.wrong : all.right;
        list.insert(list.end(), some.begin(), some.end());
    }
    return all;
}

std::string shared(const std::vector<const PointTrait*>& traits) {
    if (traits.empty()) return "";
    std::vector<std::string_view> words;
    for (const PointTrait* trait : traits)
        words.push_back(trait->words);
    return fmt::format(" All of these have in common that {}.", fmt::join(words, ", and that "));
}

}  // namespace

std::optional<Finding> checkMixed(const std::vector<const ShadowLog*>& logs,
                                  const ShadowReading& reading, bool raysSeen) {
    const Sorted points = sorted(logs, reading, raysSeen);
    if (points.wrong.empty()) return std::nullopt;
    const std::vector<const PointTrait*> traits = tellingTraits(points.wrong, points.right);
    const std::size_t all = points.wrong.size() + points.right.size();
    Finding finding = distributedFinding(
        kShadowWrong, Severity::fail,
        fmt::format("In usual scenes the colours are right; in scenes with unusual lights, "
                    "materials and places the colour is another one than expected at {} of {} "
                    "points.{}",
                    points.wrong.size(), all, shared(traits)));
    const bool hasHint = !traits.empty() && !traits.front()->hint.empty();
    finding.hint = hasHint ? std::string{traits.front()->hint}
                           : "illuminate treats every light, surface and place in the same way: "
                             "leave out limits and special cases of your own.";
    finding.section = "Soft shadows (T2.1), step 3";
    finding.evidence.emplace_back("wrongPoints", static_cast<double>(points.wrong.size()));
    finding.evidence.emplace_back("points", static_cast<double>(all));
    return finding;
}

}  // namespace ticker::tasks
