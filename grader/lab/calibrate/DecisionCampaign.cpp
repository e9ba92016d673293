#include <grader/base/CpuTime.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/lab/calibrate/DecisionCampaign.h>
#include <grader/lab/calibrate/DecisionTables.h>
#include <grader/lab/calibrate/Seed.h>
#include <grader/result/Names.h>
#include <grader/tasks/Tasks.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace ticker::calibrate {
namespace {

constexpr std::size_t kBlock = 50;

std::string firstOf(const TaskJudgement& task) {
    return task.findings.empty() ? "nothing" : task.findings.front().id;
}

void count(const TaskJudgement& task, const corpus::Expectation& expect, bool anyWarning,
           BlockRecord& record) {
    const std::string wanted = expect.finding().empty() ? "nothing" : expect.finding();
    const bool rightState = expect.allows(toString(task.state));
    const bool rightName = firstOf(task) == wanted || (anyWarning && rightState);
    if (!rightState) ++record.wrongState;
    if (rightState && !rightName) ++record.wrongName;
    if (task.needsReview) ++record.reviews;
    if (!rightState || !rightName || task.needsReview) ++record.seen[firstOf(task)];
}

void count(const Subject& subject, const std::vector<TaskReport>& reports, BlockRecord& record) {
    const corpus::Expectation passes{{"passed"}, {{}}, false};
    const bool anyWarning = subject.task.empty();
    ++record.decisions;
    for (const TaskReport& report : reports)
        count(report, report.id == subject.task ? subject.expect : passes, anyWarning, record);
}

}  // namespace

DecisionCampaign::DecisionCampaign(std::string name, std::vector<Subject> subjects,
                                   const std::function<std::size_t(const Subject&)>& decisions,
                                   Programs& programs)
    : name_(std::move(name)), subjects_(std::move(subjects)), programs_(programs) {
    std::vector<std::size_t> rounds;
    for (const Subject& subject : subjects_)
        rounds.push_back((decisions(subject) + kBlock - 1) / kBlock);
    const std::size_t most = rounds.empty() ? 0 : *std::max_element(rounds.begin(), rounds.end());
    for (std::size_t round = 0; round < most; ++round)
        for (std::size_t i = 0; i < subjects_.size(); ++i)
            if (round < rounds[i]) blocks_.push_back({i, round});
}

std::string DecisionCampaign::unitName(std::size_t unit) const {
    const Block& block = blocks_.at(unit);
    return fmt::format("{} {}", subjects_[block.subject].name, block.round);
}

// Fast subjects that draw every number from the kit's generator, spread over the first round.
std::vector<std::size_t> DecisionCampaign::checkUnits() const {
    std::vector<std::size_t> units;
    for (const std::string_view wanted : kQuick)
        for (std::size_t unit = 0; unit < blocks_.size(); ++unit)
            if (blocks_[unit].round == 0 && subjects_[blocks_[unit].subject].name == wanted)
                units.push_back(unit);
    return units;
}

// A subject's other task is the reference's. It is judged in the first round, and in every round if
// the subject must pass.
std::string DecisionCampaign::run(std::size_t unit) {
    const Block& block = blocks_.at(unit);
    const Subject& subject = subjects_[block.subject];
    const build::Program& program = programs_.of(subject);
    const bool whole = subject.isRight() || block.round == 0;
    const std::string only = whole ? "" : subject.task;
    const sandbox::Limits limits;
    BlockRecord record;
    record.subject = subject.name;
    record.seed = seedOf(subject.name) + block.round * kBlock;
    record.whole = whole;
    for (std::size_t i = 0; i < kBlock; ++i) {
        build::SandboxedExaminee examinee{program, programs_.sandbox(), limits};
        const double before = threadCpuMs();
        count(subject,
              tasks::judgeFile(defaultExercise(), subject.file, examinee, record.seed + i, only),
              record);
        const double cpuMs = threadCpuMs() - before + examinee.cpuMs();
        ++record.cpu[static_cast<int>(std::lround(cpuMs / kCpuStep)) * kCpuStep];
    }
    return record.json();
}

Summary DecisionCampaign::summarise(const std::vector<std::string>& records) const {
    return tablesOf(subjects_, records);
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
