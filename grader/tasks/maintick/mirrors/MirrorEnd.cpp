#include <grader/probe/AnswerMemory.h>
#include <grader/tasks/maintick/Exact.h>
#include <grader/tasks/maintick/MirrorFindings.h>
#include <grader/tasks/maintick/mirrors/MirrorEnd.h>
#include <grader/tasks/maintick/mirrors/MirrorQuestions.h>

#include <fmt/core.h>

#include <variant>

namespace ticker::tasks::maintick {
namespace {

using Kind = probe::ProcessEnd::Kind;

const probe::IlluminateAnswer& answerAt(const probe::Run& run, std::size_t question) {
    return std::get<probe::IlluminateAnswer>(run.answers.at(question));
}

bool isWhole(const probe::IlluminateAnswer& answer) {
    return answer.state == probe::AnswerState::answered;
}

/// Whether the first ray of the answer, that with the fewest bounces, came back.
bool hasFirst(const probe::IlluminateAnswer& answer) {
    return !answer.colours.empty() && !probe::isUnanswered(answer.colours.front());
}

}  // namespace

std::optional<Finding> checkMirrorEnd(const probe::Run& run) {
    const Kind kind = run.end.kind;
    if (kind != Kind::crashed && kind != Kind::timedOut && kind != Kind::memory)
        return std::nullopt;
    const probe::IlluminateAnswer& deep = answerAt(run, kDeep);
    if (isWhole(answerAt(run, kFacing)) && isWhole(deep)) return std::nullopt;
    if (!isWhole(answerAt(run, kFacing)) || !hasFirst(deep))
        return failure(kMirrorEndless,
                       "trace was asked about two mirrors that face each other, with at most 4 "
                       "bounces left: it never came back.");
    return failure(kMirrorBounces,
                   fmt::format("trace was asked about two mirrors that face each other: with few "
                               "bounces left it came back, with up to {} it did not.",
                               kDeepest),
                   "bouncesLeft alone says how many reflections are followed: an array of a fixed "
                   "size is too short for more.");
}

bool isSlowWithManyBounces(const probe::Run& run) {
    return run.end.kind == Kind::timedOut && isWhole(answerAt(run, kFacing)) &&
           !isWhole(answerAt(run, kDeep)) && hasFirst(answerAt(run, kDeep));
}

}  // namespace ticker::tasks::maintick
