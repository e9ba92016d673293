#include <grader/build/SandboxedExaminee.h>

#include <grader/intake/Utf8.h>
#include <grader/probe/AnswerMemory.h>
#include <grader/probe/Wire.h>
#include <grader/sandbox/SharedMemory.h>

#include <fmt/core.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <string_view>

namespace ticker::build {
namespace {

using probe::ProcessEnd;
using sandbox::Outcome;
using Kind = ProcessEnd::Kind;

constexpr const char* kBadAlloc = "std::bad_alloc";

// The exception that the C++ library throws when memory runs out, where it was caught.
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

ProcessEnd endBySignal(const Outcome& outcome) {
    const std::string name = signalName(outcome.code);
    switch (outcome.code) {
        case SIGSYS:
            return {Kind::forbiddenCall, "a system call that a renderer does not need"};
        case SIGXCPU:
        case SIGKILL:
            return {Kind::timedOut,
                    fmt::format("stopped after {:.1f} s of computing", outcome.cpuMs / 1000.0)};
        case SIGXFSZ:
            return {Kind::outputLimit, "wrote more than a file may hold"};
        case SIGABRT:
            if (outcome.output.find(kBadAlloc) != std::string::npos)
                return {Kind::memory, "ran out of memory (std::bad_alloc)"};
            return {Kind::crashed, name + ": abort, by std::terminate or the like"};
        case SIGSEGV:
            return {Kind::crashed, name +
                                       ": a bad pointer, an index out of range, or a recursion "
                                       "without end"};
        default:
            return {Kind::crashed, name};
    }
}

ProcessEnd endOf(const Outcome& outcome, bool finished, const sandbox::Limits& limits) {
    if (outcome.end == Outcome::End::failed)
        return {Kind::ourFault, intake::asUtf8(outcome.output)};
    if (finished) return {};
    switch (outcome.end) {
        case Outcome::End::wallLimit:
            return {Kind::timedOut, fmt::format("stopped after {:.0f} s", limits.wallSeconds)};
        case Outcome::End::outputLimit:
            return {Kind::outputLimit,
                    fmt::format("printed more than {} bytes", limits.outputBytes)};
        case Outcome::End::signalled:
            return endBySignal(outcome);
        default:
            return {Kind::exitedEarly, fmt::format("left with exit status {}", outcome.code)};
    }
}

}  // namespace

probe::Sitting SandboxedExaminee::ask(const std::vector<probe::Question>& questions) {
    const probe::AnswerLayout layout = probe::layoutFor(questions);
    const sandbox::FileDescriptor message = sandbox::sealedCopy(probe::encodeQuestions(questions));
    const sandbox::SharedMemory memory{layout.totalBytes};
    probe::fillUnanswered(memory.bytes(), layout);

    sandbox::Command command;
    command.arguments = {"/probe"};
    command.readOnly = {{program_.file(), "/probe"}};
    command.descriptors = {{message.get(), 3}, {memory.descriptor(), 4}};
    command.policy = sandbox::Policy::run;
    command.limits = limits_;
    const Outcome outcome = sandbox_.run(command);
    cpuMs_ += outcome.cpuMs;
    wallMs_ += outcome.wallMs;

    probe::Sitting sitting{probe::readAnswers(questions, memory.bytes()),
                           endOf(outcome, probe::saysFinished(memory.bytes()), limits_)};
    if (sitting.end.kind == Kind::finished && std::ranges::any_of(sitting.answers, saysOutOfMemory))
        sitting.end = {Kind::memory, "ran out of memory (std::bad_alloc)"};
    return sitting;
}

}  // namespace ticker::build
