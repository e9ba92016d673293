#include <grader/result/GeneralFindings.h>
#include <grader/tasks/support/RunEnd.h>

#include <fmt/core.h>

#include <string>
#include <utility>

namespace ticker::tasks {
namespace {

using probe::AnswerState;
using Kind = probe::ProcessEnd::Kind;

// State and message of the first incomplete answer; `answered` if all are complete.
struct Missing {
    AnswerState state = AnswerState::answered;
    std::string message;
};

Missing firstMissing(const probe::Run& run) {
    for (const probe::Answer& answer : run.answers) {
        const Missing missing = std::visit(
            [](const auto& given) {
                return Missing{given.state, given.message};
            },
            answer);
        if (missing.state != AnswerState::answered) return missing;
    }
    return {};
}

}  // namespace

BadEnd badEnd(Kind kind) {
    switch (kind) {
        case Kind::crashed:
            return {kRunCrashed.id, "it crashed",
                    "Run it in a debugger, or with sanitizers on. Look for an index beyond the end "
                    "of an array or a vector (x and y exchanged, say), and for a function that "
                    "calls itself without end."};
        case Kind::exitedEarly:
            return {kRunExitedEarly.id, "the program left before it had answered",
                    "Do not call exit() or the like."};
        case Kind::timedOut:
            return {kRunTimedOut.id, "it was still busy when its time was up",
                    "Look for a loop that does not end, or for far more rays than asked for."};
        case Kind::memory:
            return {
                kRunMemory.id, "it ran out of memory",
                "Look for a container that only grows, and for an array that is far too large."};
        case Kind::outputLimit:
            return {kRunOutputLimit.id, "it printed too much", "Remove the debugging output."};
        case Kind::forbiddenCall:
            return {kRunForbiddenCall.id,
                    "it asked the system for something that a renderer does not need",
                    "No files, processes or network connections are needed here."};
        case Kind::finished:
        case Kind::ourFault:
            break;
    }
    return {kRunNoAnswer.id, "no answer came", "Make sure that the function returns."};
}

std::optional<TaskJudgement> judgeUnanswered(const probe::Run& run, std::string_view function) {
    TaskJudgement judgement;
    if (run.end.kind == Kind::ourFault) {
        judgement.state = TaskState::notGraded;
        judgement.reason = "The program could not be run: " + run.end.detail;
        return judgement;
    }
    const Missing missing = firstMissing(run);
    const bool hasAll = missing.state == AnswerState::answered;
    if (hasAll && run.end.kind == Kind::finished) return std::nullopt;

    BadEnd end = badEnd(run.end.kind);
    std::string seen{end.seen};
    if (missing.state == AnswerState::threw) {
        end = {kRunCrashed.id, "",
               "Find out where the exception comes from; no handler catches it."};
        seen = fmt::format("an exception came out of it: {}", missing.message);
    } else if (!run.end.detail.empty()) {
        seen += " (" + run.end.detail + ")";
    }
    Finding finding;
    finding.id = end.id;
    finding.severity = Severity::fail;
    finding.message = fmt::format("{} was asked for values; {}.", function, seen);
    finding.hint = end.hint;
    judgement.state = TaskState::blocked;
    judgement.reason = finding.message;
    judgement.findings.push_back(std::move(finding));
    return judgement;
}

}  // namespace ticker::tasks
