#include <grader/repair/SwitchedProgram.h>

#include <grader/probe/AnswerMemory.h>
#include <grader/probe/Wire.h>
#include <grader/repair/probe/Switches.h>
#include <grader/sandbox/SharedMemory.h>

#include <raytracer/base/Error.h>

#include <algorithm>
#include <utility>

namespace ticker::repair {
namespace {

// Most bytes of all answers of one process.
constexpr std::size_t kMostBytes = 256U << 20U;

EditRound roundOf(const EditSet& set) {
    if (set.size() > EditRound::kMost) throw raytracer::Error("too many edits at once");
    EditRound round{};
    std::ranges::fill(round.edits, EditRound::kNoEdit);
    std::ranges::copy(set, std::begin(round.edits));
    return round;
}

/// @param isMeasured  A round without edits comes first.
std::vector<EditRound> roundsOf(std::span<const EditSet> sets, bool isMeasured) {
    std::vector<EditRound> rounds;
    if (isMeasured) rounds.push_back(roundOf({EditRound::kMeasure}));
    for (const EditSet& set : sets)
        rounds.push_back(roundOf(set));
    return rounds;
}

}  // namespace

std::size_t SwitchedProgram::askTogether(const std::vector<probe::Question>& questions,
                                         std::span<const EditSet> sets, std::size_t first,
                                         const UseRun& use) const {
    const probe::AnswerLayout layout = probe::layoutFor(questions);
    const std::vector<EditRound> rounds = roundsOf(sets, isMeasured_ && sets.size() > 1);
    const FileDescriptor message = sandbox::sealedCopy(probe::encodeQuestions(questions));
    const FileDescriptor edits = sandbox::sealedCopy(std::as_bytes(std::span{rounds}));
    const sandbox::SharedMemory memory{layout.totalBytes * sets.size()};
    const auto part = [&](std::size_t i) -> probe::CopyBytes {
        return [&memory, begin = i * layout.totalBytes](std::size_t at, std::span<std::byte> to) {
            memory.read(begin + at, to);
        };
    };
    const std::vector<std::byte> unanswered = probe::unanswered(layout);
    for (std::size_t i = 0; i < sets.size(); ++i)
        memory.write(i * layout.totalBytes, unanswered);

    sandbox::Command command;
    command.arguments = {"/probe"};
    command.readOnly = {{program_.file(), "/probe"}};
    command.descriptors = {{message.get(), kSwitchedQuestions},
                           {memory.descriptor(), kSwitchedAnswers},
                           {edits.get(), kSwitchedEdits}};
    command.policy = sandbox::Policy::run;
    command.limits = clock_.cut(limits_);
    const sandbox::Outcome outcome = sandbox_.run(command);
    clock_.add(Work::ask, outcome.cpuMs);
    if (outcome.end == sandbox::Outcome::End::failed) throw raytracer::Error(outcome.output);

    for (std::size_t i = 0; i < sets.size(); ++i) {
        probe::Run run{probe::readAnswers(questions, part(i)), {}};
        const bool finished = probe::saysFinished(part(i));
        if (!finished) run.end = {probe::ProcessEnd::Kind::crashed, "with an edit"};
        use(first + i, std::move(run));
        // Those after it were not asked.
        if (!finished) return i + 1;
    }
    return sets.size();
}

void SwitchedProgram::askEach(const std::vector<probe::Question>& questions,
                              std::span<const EditSet> sets, const UseRun& use) const {
    // After a process that ended early, the next one goes on behind the set that ended it.
    const std::size_t bytesEach = std::max<std::size_t>(1, probe::layoutFor(questions).totalBytes);
    const std::size_t most = keepsState_ ? 1 : std::max<std::size_t>(1, kMostBytes / bytesEach);
    for (std::size_t at = 0; at < sets.size() && !clock_.isStepOver();) {
        const std::size_t count = std::min(most, sets.size() - at);
        at += askTogether(questions, sets.subspan(at, count), at, use);
    }
}

std::vector<probe::Run> SwitchedProgram::ask(const std::vector<probe::Question>& questions,
                                             std::span<const EditSet> sets) const {
    std::vector<probe::Run> all;
    askEach(questions, sets,
            [&](std::size_t /*set*/, probe::Run run) { all.push_back(std::move(run)); });
    return all;
}

probe::Run EditedExaminee::ask(const std::vector<probe::Question>& questions) {
    if (first_) return *std::exchange(first_, std::nullopt);
    const EditSet sets[] = {set_};
    std::vector<probe::Run> runs = program_.ask(questions, sets);
    if (!runs.empty()) return std::move(runs.front());
    const probe::AnswerLayout layout = probe::layoutFor(questions);
    std::vector<std::byte> nothing = probe::unanswered(layout);
    nothing.resize(layout.totalBytes);
    return {probe::readAnswers(questions, nothing),
            {probe::ProcessEnd::Kind::timedOut, "the search is over"}};
}

}  // namespace ticker::repair
