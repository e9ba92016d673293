#include <grader/base/CpuTime.h>
#include <grader/base/Workers.h>
#include <grader/build/Build.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/exercise/Exercise.h>
#include <grader/lab/selftest/MistakeTables.h>
#include <grader/result/Names.h>
#include <grader/tasks/JudgeDistributed.h>
#include <grader/tasks/Tasks.h>
#include <grader/tasks/bump/JudgeBump.h>

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <mutex>
#include <string_view>
#include <utility>

namespace ticker::selftest {
namespace {

using corpus::Entry;

std::string firstFinding(const TaskJudgement& judgement) {
    return judgement.findings.empty() ? "" : judgement.findings.front().id;
}

std::string told(const TaskJudgement& judgement) {
    std::string text = std::string{toString(judgement.state)};
    if (!judgement.findings.empty()) text += " " + firstFinding(judgement);
    if (judgement.needsReview) text += " (review)";
    return text;
}

std::string told(const corpus::Expectation& expected) {
    const std::string text = fmt::format("{}", fmt::join(expected.states, "|"));
    const std::string findings =
        fmt::format("{}", fmt::join(expected.findings.value_or(std::vector<std::string>{}), "|"));
    return text + (findings.empty() ? "" : " ") + findings +
           (expected.needsReview ? " (review)" : "");
}

/// An entry, and the file that results from its edits.
struct Made {
    Entry entry;
    std::string source;
};

std::vector<Made> make(const std::vector<Entry>& entries) {
    std::vector<Made> made;
    for (const Entry& entry : entries)
        made.push_back({entry, corpus::textsOf(entry).at(entry.file())});
    return made;
}

std::vector<Made> pick(std::vector<Made> all, const MistakeRun& run) {
    std::vector<Made> picked;
    double owed = static_cast<double>(run.seed % 97) / 97.0;
    for (Made& made : all) {
        owed += run.fraction;
        if (owed < 1.0) continue;
        owed -= 1.0;
        picked.push_back(std::move(made));
    }
    if (picked.empty() && !all.empty()) picked.push_back(std::move(all.front()));
    return picked;
}

bool isAsExpected(const TaskJudgement& own, const corpus::Expectation& expected) {
    return expected.isMet(toString(own.state), firstFinding(own)) &&
           own.needsReview == expected.needsReview;
}

void judgeT1(probe::Examinee& examinee, std::uint64_t seed, MistakeRow& row) {
    const TaskJudgement own = tasks::judgeBump(examinee, seed);
    row.seen = told(own);
    row.asExpected = isAsExpected(own, row.entry.expected());
}

void judgeT2(probe::Examinee& examinee, std::uint64_t seed, MistakeRow& row) {
    const auto judgement = tasks::judgeDistributed(examinee, {}, seed);
    const bool shadows = row.entry.task() == "T2.1";
    const TaskJudgement& own = shadows ? judgement.softShadows : judgement.depthOfField;
    const TaskJudgement& other = shadows ? judgement.depthOfField : judgement.softShadows;
    const bool otherPassed =
        other.state == TaskState::passed && other.findings.empty() && !other.needsReview;
    row.seen = told(own);
    if (!otherPassed) row.seen += ", other task " + told(other);
    row.asExpected = isAsExpected(own, row.entry.expected()) && otherPassed;
}

/// The first line with a compiler error.
std::string firstError(const std::string& diagnostics) {
    const std::size_t error = std::min(diagnostics.find("error"), diagnostics.size());
    const std::size_t newline = diagnostics.rfind('\n', error);
    const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
    return diagnostics.substr(begin, diagnostics.find('\n', error) - begin);
}

/// All tasks of the entry's file, by their rows.
void judgeByRows(const Exercise& exercise, probe::Examinee& examinee, std::uint64_t seed,
                 MistakeRow& row) {
    row.asExpected = true;
    for (const Task& task : tasks::tasksOf(exercise.name)) {
        const std::string id{task.id};
        if (exercise.fileOf(id) != exercise.fileOf(row.entry.task())) continue;
        const TaskJudgement judgement = task.judge(examinee, seed);
        const auto expected = row.entry.tasks.find(id);
        const bool isExpected = expected != row.entry.tasks.end()
                                    ? isAsExpected(judgement, expected->second)
                                    : judgement.state == TaskState::passed;
        if (id == row.entry.task() || !isExpected)
            row.seen += (row.seen.empty() ? "" : ", ") + id + " " + told(judgement);
        row.asExpected = row.asExpected && isExpected;
    }
}

MistakeRow runOne(const Made& made, const build::Kit& kit, const sandbox::Sandbox& sandbox,
                  const MistakeRun& run) {
    const sandbox::Limits limits;
    const bool bump = made.entry.task() == "T1";
    const std::string file{run.exercise->fileOf(made.entry.task())};
    const build::BuildResult built = build::buildProgram(kit, sandbox, limits, file, made.source);
    MistakeRow row;
    row.entry = made.entry;
    if (!built.program) {
        row.seen = "does not compile: " + firstError(built.diagnostics);
        return row;
    }
    build::SandboxedExaminee examinee{*built.program, sandbox, limits};
    const double before = threadCpuMs();
    if (run.exercise != &defaultExercise())
        judgeByRows(*run.exercise, examinee, run.seed, row);
    else
        (bump ? judgeT1 : judgeT2)(examinee, run.seed, row);
    row.judgeMs = threadCpuMs() - before;
    row.probeMs = examinee.cpuMs();
    return row;
}

}  // namespace

std::vector<Entry> mistakesOf(const std::vector<Entry>& catalogue, const std::string& task) {
    std::vector<Entry> found;
    std::ranges::copy_if(catalogue, std::back_inserter(found),
                         [&](const Entry& entry) { return entry.task().starts_with(task); });
    return found;
}

std::vector<Entry> mistakesCalled(const std::vector<Entry>& catalogue,
                                  const std::vector<std::string>& ids) {
    std::vector<Entry> found;
    for (const std::string& id : ids) {
        const std::size_t before = found.size();
        std::ranges::copy_if(catalogue, std::back_inserter(found), [&](const Entry& entry) {
            return entry.name == id || entry.task() + "/" + entry.name == id;
        });
        if (found.size() > before) continue;
        std::vector<std::string_view> known;
        for (const Entry& entry : catalogue)
            known.push_back(entry.name);
        const auto nearest = raytracer::nearestName(id, known);
        throw raytracer::InputError(
            "--case " + id, 0,
            "no mistake is called so" +
                (nearest ? fmt::format("; did you mean {}?", *nearest) : std::string{}));
    }
    return found;
}

std::vector<MistakeRow> runMistakes(const std::vector<Entry>& entries, const build::Kit& kit,
                                    const sandbox::Sandbox& sandbox, const MistakeRun& run) {
    const std::vector<Made> picked = pick(make(entries), run);
    std::vector<MistakeRow> rows(picked.size());
    std::size_t done = 0;
    std::mutex mutex;
    onWorkers(run.jobs, picked.size(), [&](std::size_t i) {
        rows[i] = runOne(picked[i], kit, sandbox, run);
        const std::lock_guard lock{mutex};
        if (run.progress) run.progress(++done, picked.size());
    });
    return rows;
}

std::string tableOf(const std::vector<MistakeRow>& rows) {
    std::string table;
    std::size_t differing = 0;
    for (const MistakeRow& row : rows) {
        if (!row.asExpected) ++differing;
        table += fmt::format("{} {:<5} {:<34} {:<38} {:4.0f} + {:3.0f} ms{}\n",
                             row.asExpected ? " " : "!", row.entry.task(), row.entry.name,
                             told(row.entry.expected()), row.probeMs, row.judgeMs,
                             row.asExpected ? "" : "   saw: " + row.seen);
    }
    return table + fmt::format("{} entries, {} not as expected\n", rows.size(), differing);
}

}  // namespace ticker::selftest
