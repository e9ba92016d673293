#include <grader/result/GeneralFindings.h>
#include <grader/tasks/support/FindingOrder.h>
#include <grader/tasks/support/RunEnd.h>
#include <grader/tasks/support/Stage.h>

#include <utility>

namespace ticker::tasks {

std::uint64_t seedOf(std::uint64_t seed, std::uint64_t stage) {
    return seed * 4 + stage;
}

Stage doubtful(const FindingText& text, std::string why) {
    return {std::nullopt, distributedFinding(text, Severity::warn, std::move(why))};
}

Stage unanswered(const probe::Run& run, std::string_view function) {
    std::optional<TaskJudgement> blocked = judgeUnanswered(run, function);
    if (!blocked || blocked->findings.empty())
        return doubtful(kRunNoAnswer, "Questions that were asked once more got no answer.");
    Finding doubt = std::move(blocked->findings.front());
    doubt.severity = Severity::warn;
    return {std::nullopt, std::move(doubt)};
}

bool keepRepeated(std::vector<Finding>& findings,
                  const std::function<Stage(std::uint64_t)>& judge) {
    Stage first = judge(1);
    if (first.failure && first.decided) {
        findings.push_back(*std::move(first.failure));
        return false;
    }
    if (first.failure) {
        Stage second = judge(2);
        if (second.failure) {
            findings.push_back(*std::move(second.failure));
            return false;
        }
        first.failure->severity = Severity::warn;
        first.failure->message +=
            " It did not come again with other questions: a person has to look.";
        first.doubt = std::move(first.failure);
    }
    if (!first.doubt) return false;
    findings.push_back(*std::move(first.doubt));
    return true;
}

}  // namespace ticker::tasks
