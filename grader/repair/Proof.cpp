#include <grader/repair/Proof.h>

#include <grader/build/Build.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/repair/TaskLookup.h>
#include <grader/repair/TimedExaminee.h>

#include <algorithm>

namespace ticker::repair {
namespace {

constexpr int kSeeds = 3;

/// One edited program, judged.
class Trial {
public:
    Trial(const build::Program& program, const pipeline::Grader& grader, std::uint64_t seed,
          Clock& clock)
        : budget_(clock.unused()),
          program_(program, grader.sandbox, grader.policy.run, &budget_),
          examinee_(
              program_, [this] { return program_.cpuMs(); }, clock),
          grader_(grader),
          seed_(seed),
          clock_(clock) {}

    std::optional<Proof> judge(const std::string& task, const std::vector<TaskReport>& before) {
        const auto was = std::ranges::find(before, task, &TaskReport::id);
        if (was == before.end()) return std::nullopt;
        Proof proof;
        double longestMs = 0.0;
        for (int i = 0; i < kSeeds; ++i) {
            // Each seed takes about as long as the others.
            if (clock_.unusedMs() < longestMs) return std::nullopt;
            const double beginMs = clock_.cpuMs();
            const TaskJudgement judgement =
                codeOf(grader_, task).judge(examinee_, seed_ + static_cast<std::uint64_t>(i));
            if (clock_.isAllUsedUp()) return std::nullopt;
            longestMs = std::max(longestMs, clock_.cpuMs() - beginMs);
            const std::string next = passes(judgement) ? "" : firstFailure(judgement);
            if (!passes(judgement) && next.empty()) return std::nullopt;
            if (addsWarning(judgement, *was)) return std::nullopt;
            if (i > 0 && next != proof.next) return std::nullopt;
            proof.next = next;
            if (i == 0) aperture_ = judgement.apertureFactor;
        }
        return proof;
    }

    bool keepsOthers(const std::string& file, const std::string& task,
                     const std::vector<TaskReport>& before) {
        return std::ranges::all_of(before, [&](const TaskReport& report) {
            if (report.id == task || report.state != TaskState::passed ||
                grader_.exercise->fileOf(report.id) != file)
                return true;
            const TaskJudgement now = codeOf(grader_, report.id).judge(examinee_, seed_);
            return passes(now) && !addsWarning(now, report) && !clock_.isAllUsedUp();
        });
    }

    /// Whether the edited program's renders show what its answers say.
    bool rendersAlike(const std::string& file, const std::string& task,
                      const std::vector<TaskReport>& before) {
        const auto doubt = codeOf(grader_, task).doubt;
        if (doubt == nullptr || grader_.scenes.empty()) return true;
        std::vector<TaskReport> reports;
        for (const TaskReport& report : before)
            if (grader_.exercise->fileOf(report.id) == file) reports.push_back(report);
        const auto own = std::ranges::find(reports, task, &TaskReport::id);
        if (own == reports.end()) return false;
        own->state = TaskState::passed;
        own->needsReview = false;
        own->findings.clear();
        own->apertureFactor = aperture_;
        if (clock_.isAllUsedUp()) return false;
        const double beginMs = program_.cpuMs();
        const pipeline::Gallery gallery =
            pipeline::renderSpecScenes(grader_.scenes, file, program_);
        clock_.add(Work::prove, program_.cpuMs() - beginMs);
        doubt(reports, {gallery.misfits, gallery.bumpMisfit});
        return passes(*own);
    }

private:
    build::TimeBudget budget_;
    build::SandboxedExaminee program_;
    TimedExaminee examinee_;
    const pipeline::Grader& grader_;
    std::uint64_t seed_;
    Clock& clock_;
    std::optional<double> aperture_;
};

}  // namespace

std::optional<Proof> prove(const std::string& edited, const std::string& file,
                           const std::string& task, const std::vector<TaskReport>& before,
                           const pipeline::Grader& grader, std::uint64_t seed, Clock& clock) {
    if (clock.isAllUsedUp()) return std::nullopt;
    const build::BuildResult built = build::buildProgram(
        grader.kit, grader.sandbox, clock.cut(grader.policy.compile), file, edited);
    clock.add(Work::prove, built.cpuMs);
    if (!built.program) return std::nullopt;
    Trial trial{*built.program, grader, seed, clock};
    std::optional<Proof> proof = trial.judge(task, before);
    if (proof && proof->next.empty() &&
        !(trial.keepsOthers(file, task, before) && trial.rendersAlike(file, task, before)))
        proof.reset();
    return proof;
}

}  // namespace ticker::repair
