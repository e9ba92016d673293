#include <grader/base/CpuTime.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/lab/calibrate/BlockRecord.h>
#include <grader/lab/calibrate/OwnNoise.h>
#include <grader/lab/calibrate/Seed.h>
#include <grader/lab/calibrate/campaigns/DecisionCampaign.h>
#include <grader/result/Names.h>
#include <grader/tasks/Tasks.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace ticker::calibrate {
namespace {

std::string firstOf(const TaskJudgement& task) {
    return task.findings.empty() ? "nothing" : task.findings.front().id;
}

void count(const TaskJudgement& task, const corpus::Expectation& expect, bool anyWarning,
           BlockRecord& record) {
    const std::string first = task.findings.empty() ? "" : task.findings.front().id;
    const bool rightState = expect.allows(toString(task.state));
    const bool rightName = anyWarning || expect.isMet(toString(task.state), first);
    if (!rightState) ++record.wrongState;
    const bool isUnexpected = task.needsReview && !expect.needsReview;
    const bool isMissing = expect.needsReview && !task.needsReview;
    if (rightState && (!rightName || isMissing)) ++record.wrongName;
    if (isUnexpected) ++record.reviews;
    if (!rightState || !rightName || isUnexpected || isMissing) ++record.seen[firstOf(task)];
}

std::vector<std::string> idsOf(const Subject& subject) {
    std::vector<std::string> ids;
    for (const TaskEntry& task : subject.exercise->tasks)
        if (task.file == subject.file) ids.push_back(task.id);
    return ids;
}

}  // namespace

DecisionCampaign::DecisionCampaign(DecisionPlan plan, Programs& programs)
    : plan_(std::move(plan)), programs_(programs) {
    std::vector<std::size_t> rounds;
    for (const Subject& subject : plan_.subjects)
        rounds.push_back((plan_.decisions(subject) + plan_.block - 1) / plan_.block);
    const std::size_t most = rounds.empty() ? 0 : *std::max_element(rounds.begin(), rounds.end());
    for (const Subject& subject : plan_.subjects)
        for (const Task& task : tasks::tasksOf(subject.exercise->name))
            judges_.try_emplace(std::string{task.id}, task);
    for (std::size_t round = 0; round < most; ++round)
        for (std::size_t i = 0; i < plan_.subjects.size(); ++i)
            if (round < rounds[i]) addBlocks(i, round);
}

// Adds the blocks of one round. The other tasks of a wrong subject are the reference's code, so
// that they are judged in the first round only.
void DecisionCampaign::addBlocks(std::size_t subject, std::size_t round) {
    const Subject& judged = plan_.subjects[subject];
    const bool others = plan_.othersToo && (judged.isRight() || round == 0);
    for (const std::string& task : idsOf(judged))
        if (others || judged.task.empty() || task == judged.task)
            blocks_.push_back({subject, task, round});
}

std::string DecisionCampaign::unitName(std::size_t unit) const {
    return fmt::format("{} {} {}", subjectOf(unit).name, blocks_[unit].task, blocks_[unit].round);
}

Campaign::Basis DecisionCampaign::basisOf(std::size_t unit) const {
    const Subject& subject = subjectOf(unit);
    return {{blocks_[unit].task}, subject.name, subject.basis()};
}

std::vector<std::size_t> DecisionCampaign::checkUnits() const {
    std::vector<std::size_t> units;
    for (std::size_t unit = 0; unit < blocks_.size(); ++unit)
        if (blocks_[unit].round == 0 &&
            std::ranges::find(plan_.checked, subjectOf(unit).name) != plan_.checked.end())
            units.push_back(unit);
    return units;
}

std::string DecisionCampaign::run(std::size_t unit) {
    const Block& block = blocks_.at(unit);
    const Subject& subject = subjectOf(unit);
    const build::Program& program = programs_.of(subject);
    const corpus::Expectation passes{{"passed"}, {{}}, false};
    const corpus::Expectation& expect = block.task == subject.task ? subject.expect : passes;
    const JudgeOfTask& judge = judges_.at(block.task);
    const bool isShared = judge.isOfMany && subject.isUnseen();
    const sandbox::Limits limits;
    BlockRecord record;
    record.subject = subject.name;
    record.task = block.task;
    record.seed = seedOf(isShared ? block.task : subject.name) + block.round * plan_.block;
    record.decisions = plan_.block;
    for (std::size_t i = 0; i < plan_.block; ++i) {
        build::SandboxedExaminee examinee{program, programs_.sandbox(), limits};
        OwnNoise noisy{examinee, seedOf(subject.name)};
        probe::Examinee& asked = isShared ? static_cast<probe::Examinee&>(noisy) : examinee;
        const double before = threadCpuMs();
        count(judge.judge(asked, record.seed + i), expect, subject.task.empty(), record);
        const double cpuMs = threadCpuMs() - before + examinee.cpuMs();
        ++record.cpu[static_cast<int>(std::lround(cpuMs / kCpuStep)) * kCpuStep];
    }
    return record.json();
}

Summary DecisionCampaign::summarise(const std::vector<std::string>& records) const {
    return plan_.tables(plan_.subjects, records);
}

std::vector<Subject> rightOnes(const std::vector<Subject>& subjects) {
    std::vector<Subject> some;
    std::copy_if(subjects.begin(), subjects.end(), std::back_inserter(some),
                 [](const Subject& subject) { return subject.isRight(); });
    return some;
}

std::vector<Subject> wrongOnes(const std::vector<Subject>& subjects) {
    std::vector<Subject> some;
    std::copy_if(subjects.begin(), subjects.end(), std::back_inserter(some),
                 [](const Subject& subject) { return !subject.isRight(); });
    return some;
}

}  // namespace ticker::calibrate
