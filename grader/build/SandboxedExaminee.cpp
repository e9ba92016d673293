#include <grader/build/SandboxedExaminee.h>

#include <grader/base/Utf8.h>
#include <grader/probe/AnswerMemory.h>
#include <grader/probe/Wire.h>
#include <grader/sandbox/SharedMemory.h>

#include <fmt/core.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace ticker::build {
namespace {

using probe::ProcessEnd;
using sandbox::Outcome;
using EndKind = ProcessEnd::Kind;

constexpr const char* kBadAlloc = "std::bad_alloc";

// Recognises std::bad_alloc, which the C++ library throws when memory runs out, if it was caught.
bool saysOutOfMemory(const probe::Answer& answer) {
    return std::visit(
        [](const auto& any) {
            return any.state == probe::AnswerState::threw && any.message == kBadAlloc;
        },
        answer);
}

std::string signalName(int signal) {
    const char* name = sigabbrev_np(signal);
    return name == nullptr ? fmt::format("signal {}", signal) : fmt::format("SIG{}", name);
}

std::string ofTheLimit(std::uint64_t bytes, const sandbox::Limits& limits) {
    constexpr double kMegabyte = 1e6;
    return fmt::format("{:.0f} MB, where it may have {:.0f} MB",
                       static_cast<double>(bytes) / kMegabyte,
                       static_cast<double>(limits.addressSpaceBytes) / kMegabyte);
}

// Describes a signal that was caused by lack of memory. Measured memory counts before printed text.
std::optional<std::string> wantOfMemory(const Outcome& outcome, const sandbox::Limits& limits) {
    if (outcome.code == SIGSYS || outcome.code == SIGXCPU || outcome.code == SIGXFSZ) return {};
    // A growing vector doubles: it has used half of the limit before the request that exceeds it.
    // SIGKILL comes where the machine has less to give than the limit.
    if (outcome.peakMemoryBytes >= limits.addressSpaceBytes / 2 ||
        (outcome.code == SIGKILL &&
         !sandbox::usedLittleMemory(outcome, limits, sandbox::Policy::run)))
        return fmt::format("{} after it had used {}", signalName(outcome.code),
                           ofTheLimit(outcome.peakMemoryBytes, limits));
    // A single oversized request uses no memory: only this message shows it.
    if (outcome.code == SIGABRT && outcome.output.find(kBadAlloc) != std::string::npos)
        return kBadAlloc;
    return {};
}

ProcessEnd endBySignal(const Outcome& outcome) {
    const std::string name = signalName(outcome.code);
    switch (outcome.code) {
        case SIGSYS:
            return {EndKind::forbiddenCall, "ended at a forbidden system call"};
        case SIGXCPU:
        case SIGKILL:
            return {EndKind::timedOut,
                    fmt::format("stopped after {:.1f} s of computing", outcome.cpuMs / 1000.0)};
        case SIGXFSZ:
            return {EndKind::outputLimit, "wrote more than a file may hold"};
        case SIGABRT:
            return {EndKind::crashed, name + ": abort, by std::terminate or the like"};
        case SIGSEGV:
            return {EndKind::crashed, name +
                                          ": a bad pointer, an index out of range, or a recursion "
                                          "without end"};
        default:
            return {EndKind::crashed, name};
    }
}

ProcessEnd endByExit(int status) {
    if (status == sandbox::kNotExecutable)
        return {EndKind::exitedEarly,
                "could not be started at all, or left with exit status 126 of its own"};
    return {EndKind::exitedEarly, fmt::format("left with exit status {}", status)};
}

std::string ofTheBudget(const sandbox::TimeLimits& all) {
    return fmt::format(
        "all runs of a submission together may take {:.0f} s, and {:.0f} s of computing",
        all.wallSeconds, all.cpuSeconds);
}

bool isMissing(const probe::Answer& answer) {
    return std::visit([](const auto& any) { return any.state == probe::AnswerState::missing; },
                      answer);
}

// The submission itself sets the mark. It counts only if all answers are complete and the kernel
// reports neither a signal nor a failure.
bool hasFinished(const Outcome& outcome, bool isMarked, const std::vector<probe::Answer>& answers) {
    const bool contradicts = outcome.end == Outcome::End::signalled ||
                             (outcome.end == Outcome::End::exited && outcome.code != 0);
    return isMarked && !contradicts && std::ranges::none_of(answers, isMissing);
}

ProcessEnd endOf(const Outcome& outcome, bool finished, const Program& program,
                 const sandbox::Limits& limits) {
    if (outcome.end == Outcome::End::failed) return {EndKind::ourFault, asUtf8(outcome.output)};
    if (finished) return {};
    const bool mayNeverHaveBegun =
        outcome.end == Outcome::End::signalled ||
        (outcome.end == Outcome::End::exited && outcome.code == sandbox::kNotExecutable);
    if (const std::uint64_t bytes = program.staticBytes();
        mayNeverHaveBegun && bytes >= limits.addressSpaceBytes)
        return {EndKind::memory,
                "its global and static variables take " + ofTheLimit(bytes, limits)};
    switch (outcome.end) {
        case Outcome::End::wallLimit:
            return {EndKind::timedOut, fmt::format("stopped after {:.0f} s", limits.wallSeconds)};
        case Outcome::End::outputLimit:
            return {EndKind::outputLimit,
                    fmt::format("printed more than {} bytes", limits.outputBytes)};
        case Outcome::End::signalled:
            if (auto why = wantOfMemory(outcome, limits)) return {EndKind::memory, std::move(*why)};
            return endBySignal(outcome);
        default:
            return endByExit(outcome.code);
    }
}

}  // namespace

// If the time budget is spent, the program is not started at all.
Outcome SandboxedExaminee::run(const sandbox::Command& command) {
    if (budget_ != nullptr && budget_->isSpent()) {
        Outcome none;
        none.end = Outcome::End::wallLimit;
        return none;
    }
    Outcome outcome = sandbox_.run(command);
    cpuMs_ += outcome.cpuMs;
    wallMs_ += outcome.wallMs;
    if (budget_ != nullptr) budget_->spend(outcome);
    return outcome;
}

probe::Run SandboxedExaminee::ask(const std::vector<probe::Question>& questions) {
    const probe::AnswerLayout layout = probe::layoutFor(questions);
    const FileDescriptor message = sandbox::sealedCopy(probe::encodeQuestions(questions));
    const sandbox::SharedMemory memory{layout.totalBytes};
    memory.write(0, probe::unanswered(layout));

    sandbox::Command command;
    command.arguments = {"/probe"};
    command.readOnly = {{program_.file(), "/probe"}};
    command.descriptors = {{message.get(), 3}, {memory.descriptor(), 4}};
    command.policy = sandbox::Policy::run;
    command.limits = budget_ == nullptr ? limits_ : budget_->cut(limits_);
    const Outcome outcome = run(command);

    const auto copy = [&](std::size_t at, std::span<std::byte> to) { memory.read(at, to); };
    probe::Run run{probe::readAnswers(questions, copy), {}};
    const bool finished = hasFinished(outcome, probe::saysFinished(copy), run.answers);
    run.end = endOf(outcome, finished, program_, command.limits);
    if (run.end.kind == EndKind::timedOut && budget_ != nullptr && budget_->isSpent())
        run.end.detail = ofTheBudget(budget_->all());
    madeForbiddenCall_ = madeForbiddenCall_ || run.end.kind == EndKind::forbiddenCall;
    if (run.end.kind == EndKind::finished && std::ranges::any_of(run.answers, saysOutOfMemory))
        run.end = {EndKind::memory, kBadAlloc};
    return run;
}

}  // namespace ticker::build
