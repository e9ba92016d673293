#include <grader/tasks/shadows/ScreenShadows.h>

#include <grader/tasks/shadows/answers/ShadowReplay.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/shadows/questions/ShadowQuestions.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace ticker::tasks {
namespace {

bool castsRays(const std::vector<const ShadowLog*>& logs) {
    return std::ranges::any_of(logs, [](const ShadowLog* log) {
        return std::ranges::any_of(log->points,
                                   [](const PointLog& point) { return point.lineCount() > 0; });
    });
}

bool fitsAReading(const std::vector<const ShadowLog*>& logs) {
    return std::ranges::any_of(acceptedShadowReadings(), [&](const ShadowReading& reading) {
        return std::ranges::all_of(logs, [&](const ShadowLog* log) {
            return allFit(*log, reading, ShadowArithmetic::right);
        });
    });
}

/// Whether the judge might pass the code, as far as cheap checks tell.
bool mayPass(const std::vector<ShadowQuestion>& asked, const probe::Run& run) {
    std::vector<ShadowLog> all;
    for (std::size_t i = 0; i < asked.size() && i < run.answers.size(); ++i) {
        const auto* answer = std::get_if<probe::IlluminateAnswer>(&run.answers[i]);
        if (answer == nullptr || answer->state != probe::AnswerState::answered) return false;
        all.push_back(readShadowLog(asked[i], *answer));
    }
    const ShadowLogs logs{all};
    if (checkFinite(logs)) return false;
    // Values without rays take long to judge: edits that hide the rays, and those of code whose
    // rays are hidden, are left out.
    if (!castsRays(logs.oneLight)) return false;
    return !checkBackwards(logs) && !checkRayCounts(logs, false) && !checkStarts(logs) &&
           fitsAReading(logs.oneLight) && fitsAReading(logs.severalLights) &&
           fitsAReading(logs.beyondLight);
}

}  // namespace

Screening screenShadows(std::uint64_t seed) {
    std::vector<ShadowQuestion> asked = drawShadowQuestions(seed);
    std::erase_if(asked, [](const ShadowQuestion& question) {
        using Purpose = ShadowQuestion::Purpose;
        return question.purpose != Purpose::oneLight &&
               question.purpose != Purpose::severalLights &&
               question.purpose != Purpose::beyondLight;
    });
    std::vector<probe::Question> questions;
    for (const ShadowQuestion& question : asked)
        questions.emplace_back(question.question);
    const auto shared = std::make_shared<const std::vector<ShadowQuestion>>(std::move(asked));
    return {std::move(questions),
            [shared](const probe::Run& run) { return mayPass(*shared, run); }};
}

}  // namespace ticker::tasks
