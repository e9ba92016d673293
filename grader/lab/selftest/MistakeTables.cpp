#include <grader/base/CpuTime.h>
#include <grader/base/Workers.h>
#include <grader/build/Build.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/exercise/Exercise.h>
#include <grader/lab/EvenShare.h>
#include <grader/lab/selftest/MistakeTables.h>
#include <grader/result/Names.h>
#include <grader/tasks/Tasks.h>

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

/// An entry, and the text of its task's file, or else of the file that it edits or adds.
struct Made {
    Entry entry;
    std::string source;
};

std::vector<Made> make(const std::vector<Entry>& entries, const Exercise& exercise) {
    std::vector<Made> made;
    for (const Entry& entry : entries) {
        const auto texts = corpus::textsOf(entry);
        const auto own = texts.find(std::string{exercise.fileOf(entry.task())});
        made.push_back({entry, own != texts.end() ? own->second : texts.at(entry.file())});
    }
    return made;
}

bool isAsExpected(const TaskJudgement& own, const corpus::Expectation& expected) {
    return expected.isMet(toString(own.state), firstFinding(own)) &&
           own.needsReview == expected.needsReview;
}

/// Whether another task's result is the one that the entry expects; without an expectation the task
/// must pass, without findings and review.
bool isOtherAsExpected(const TaskReport& report, const corpus::Entry& entry) {
    if (const auto named = entry.tasks.find(report.id); named != entry.tasks.end())
        return isAsExpected(report, named->second);
    return report.state == TaskState::passed && report.findings.empty() && !report.needsReview;
}

/// Judges the entry's file and sets the row's result: whether its task and the file's other tasks
/// are as expected.
void judge(probe::Examinee& examinee, std::string_view file, const MistakeRun& run,
           MistakeRow& row) {
    row.asExpected = true;
    for (const TaskReport& report : tasks::judgeFile(*run.exercise, file, examinee, run.seed)) {
        if (report.id == row.entry.task()) {
            row.seen = told(report) + row.seen;
            row.asExpected = isAsExpected(report, row.entry.expected()) && row.asExpected;
        } else if (!isOtherAsExpected(report, row.entry)) {
            row.seen += ", other task " + told(report);
            row.asExpected = false;
        }
    }
}

/// The first line with a compiler error.
std::string firstError(const std::string& diagnostics) {
    const std::size_t error = std::min(diagnostics.find("error"), diagnostics.size());
    const std::size_t newline = diagnostics.rfind('\n', error);
    const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
    return diagnostics.substr(begin, diagnostics.find('\n', error) - begin);
}

MistakeRow runOne(const Made& made, const build::Kit& kit, const sandbox::Sandbox& sandbox,
                  const MistakeRun& run) {
    const sandbox::Limits limits;
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
    judge(examinee, file, run, row);
    row.judgeMs = threadCpuMs() - before;
    row.probeMs = examinee.cpuMs();
    return row;
}

}  // namespace

std::vector<Entry> mistakesOf(const std::vector<Entry>& catalogue,
                              const std::vector<std::string>& tasks) {
    std::vector<Entry> found;
    std::ranges::copy_if(catalogue, std::back_inserter(found), [&](const Entry& entry) {
        return std::ranges::count(tasks, entry.task()) > 0;
    });
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
    const std::vector<Made> picked = lab::evenShare(make(entries, *run.exercise), run.fraction,
                                                    static_cast<double>(run.seed % 97) / 97.0);
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
