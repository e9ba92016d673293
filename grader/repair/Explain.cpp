#include <grader/repair/Explain.h>

#include <grader/repair/Candidates.h>
#include <grader/repair/EditSets.h>
#include <grader/repair/LineEdits.h>
#include <grader/repair/Proof.h>
#include <grader/repair/Search.h>
#include <grader/repair/SwitchedProgram.h>
#include <grader/repair/TaskLookup.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace ticker::repair {
namespace {

// CPU time of a task's search, in milliseconds, after which no more single edits, twins and pairs
// are tried.
constexpr double kSinglesMs = 4000.0;
constexpr double kTwinsMs = 7000.0;
constexpr double kPairsMs = 9000.0;
constexpr std::size_t kMostRepairs = 3;

/// The edits of one file, and the program that carries them.
struct Workshop {
    std::string file;
    std::string source;
    Candidates candidates;
    std::optional<SwitchedProgram> program;
};

std::optional<Workshop> openWorkshop(const std::string& file, const std::string& source,
                                     const pipeline::Grader& grader, double& cpuMs) {
    auto candidates =
        findCandidates(grader.kit, grader.sandbox, grader.policy.compile, file, source);
    if (!candidates) return std::nullopt;
    cpuMs += candidates->cpuMs;
    build::BuildResult built =
        build::buildProgram(grader.kit, grader.sandbox, grader.policy.compile, file,
                            candidates->program, build::Purpose::switched);
    cpuMs += built.cpuMs;
    if (!built.program) return std::nullopt;
    std::optional<Workshop> workshop{{file, source, *std::move(candidates), std::nullopt}};
    workshop->program.emplace(*std::move(built.program), grader.sandbox, grader.policy.run,
                              workshop->candidates.keepsState);
    return workshop;
}

/// One failed task.
class TaskExplanation {
public:
    TaskExplanation(const Workshop& workshop, const TaskReport& task,
                    const SubmissionResult& result, const pipeline::Grader& grader,
                    std::uint64_t seed)
        : workshop_(workshop),
          task_(task),
          result_(result),
          grader_(grader),
          seed_(seed),
          search_(codeOf(grader, task.id), *workshop.program, seed) {}

    std::vector<Repair> run() {
        const Candidates& candidates = workshop_.candidates;
        const std::string_view source = workshop_.source;
        const Choice isOwn = [this](const Atom& atom) { return !isOfAnotherTask(atom.function); };
        std::vector<Repair> repairs = proven(withoutSwitch(candidates, isOwn));
        if (repairs.empty())
            repairs = proven(search_.passing(singles(source, candidates, isOwn), kSinglesMs));
        if (repairs.empty())
            repairs = proven(search_.passing(twins(source, candidates, isOwn), kTwinsMs));
        if (repairs.empty())
            repairs = proven(search_.passing(pairs(source, candidates, isOwn), kPairsMs));
        return repairs;
    }

    [[nodiscard]] double spentMs() const { return search_.spentMs() + proofMs_; }
    [[nodiscard]] std::size_t asked() const { return search_.asked(); }

private:
    [[nodiscard]] bool isOfAnotherTask(const std::string& function) const {
        return std::ranges::any_of(grader_.exercise->tasks, [&](const TaskEntry& entry) {
            return entry.id != task_.id && entry.file == workshop_.file &&
                   entry.function.ends_with("::" + function);
        });
    }

    /// The first of some sets that are proven.
    std::vector<Repair> proven(const std::vector<EditSet>& sets) {
        std::vector<Repair> repairs;
        std::set<std::string> known;
        for (const EditSet& set : sets) {
            if (known.size() == kMostRepairs) break;
            const auto edits = textEdits(workshop_.candidates, set);
            const auto edited = withEdits(workshop_.source, edits);
            if (!edited || !known.insert(*edited).second) continue;
            const auto proof = prove(*edited, workshop_.file, task_.id, result_.tasks, grader_,
                                     seed_ + 1, proofMs_);
            if (!proof || !proof->next.empty()) continue;
            repairs.push_back({task_.id,
                               firstFailure(task_),
                               workshop_.file,
                               lineEdits(workshop_.source, edits),
                               true,
                               {}});
        }
        return repairs;
    }

    const Workshop& workshop_;
    const TaskReport& task_;
    const SubmissionResult& result_;
    const pipeline::Grader& grader_;
    std::uint64_t seed_;
    Search search_;
    double proofMs_ = 0.0;
};

}  // namespace

bool isExplainable(const TaskReport& task) {
    const std::string finding = firstFailure(task);
    if (finding.empty()) return false;
    return task.state == TaskState::failed ||
           (task.state == TaskState::blocked && finding.starts_with("run."));
}

Explanation explain(const intake::Submission& submission, const pipeline::Grader& grader,
                    const SubmissionResult& result, std::uint64_t seed) {
    Explanation explanation;
    for (const std::string& file : grader.exercise->files()) {
        const auto isOpen = [&](const TaskReport& task) {
            return grader.exercise->fileOf(task.id) == file && isExplainable(task);
        };
        const std::optional<std::string>& source = submission.part(file);
        if (!source || std::ranges::none_of(result.tasks, isOpen)) continue;
        const auto workshop = openWorkshop(file, *source, grader, explanation.cpuMs);
        if (!workshop) continue;
        for (const TaskReport& task : result.tasks) {
            if (!isOpen(task)) continue;
            TaskExplanation one{*workshop, task, result, grader, seed};
            std::vector<Repair> repairs = one.run();
            std::move(repairs.begin(), repairs.end(), std::back_inserter(explanation.repairs));
            explanation.cpuMs += one.spentMs();
            explanation.tried += one.asked();
        }
    }
    return explanation;
}

}  // namespace ticker::repair
