#include <grader/build/Build.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/decision/distributed/JudgeDistributed.h>
#include <grader/selftest/DistributedCatalogue.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <iterator>
#include <mutex>
#include <thread>
#include <utility>

#include <time.h>

namespace ticker::selftest {
namespace {

using decision::TaskJudgement;
using mistakes::Mistake;

const char* nameOf(TaskState state) {
    switch (state) {
        case TaskState::passed:
            return "passed";
        case TaskState::failed:
            return "failed";
        case TaskState::notAttempted:
            return "notAttempted";
        case TaskState::blocked:
            return "blocked";
        case TaskState::notGraded:
            return "notGraded";
    }
    return "";
}

std::string told(const TaskJudgement& judgement) {
    std::string text = nameOf(judgement.state);
    if (!judgement.findings.empty()) text += " " + judgement.findings.front().id;
    if (judgement.needsReview) text += " (review)";
    return text;
}

std::string told(const mistakes::Expectation& expected) {
    std::string text = nameOf(expected.state);
    return expected.finding.empty() ? text : text + " " + expected.finding;
}

std::vector<Mistake> pick(const std::vector<Mistake>& catalogue, const CatalogueRun& run) {
    std::vector<Mistake> all;
    std::copy_if(catalogue.begin(), catalogue.end(), std::back_inserter(all),
                 [](const Mistake& mistake) { return mistake.task.rfind("T2.", 0) == 0; });
    std::vector<Mistake> picked;
    double owed = static_cast<double>(run.seed % 97) / 97.0;
    for (const Mistake& mistake : all) {
        owed += run.fraction;
        if (owed < 1.0) continue;
        owed -= 1.0;
        picked.push_back(mistake);
    }
    if (picked.empty() && !all.empty()) picked.push_back(all.front());
    return picked;
}

double threadCpuMs() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

build::Program compile(const Mistake& mistake, const std::string& reference, const build::Kit& kit,
                       const sandbox::Sandbox& sandbox) {
    build::BuildResult built =
        build::buildProgram(kit, sandbox, sandbox::Limits{}, build::SourceFile::renderer,
                            mistakes::makeMistake(mistake, reference));
    if (!built.program)
        throw raytracer::Error(
            fmt::format("{} does not compile: {}", mistake.path, built.diagnostics));
    return std::move(*built.program);
}

void count(const decision::DistributedJudgement& judgement, CatalogueRow& row) {
    const bool shadows = row.entry.task == "T2.1";
    const TaskJudgement& own = shadows ? judgement.softShadows : judgement.depthOfField;
    const TaskJudgement& other = shadows ? judgement.depthOfField : judgement.softShadows;
    std::string seen = told(own);
    const bool rightState = own.state == row.entry.expect.state;
    const bool rightName =
        (own.findings.empty() ? "" : own.findings.front().id) == row.entry.expect.finding;
    const bool otherPassed = other.state == TaskState::passed && other.findings.empty();
    ++row.decisions;
    if (!rightState) ++row.wrongState;
    if (rightState && !rightName) ++row.wrongName;
    if (own.needsReview || other.needsReview) ++row.reviews;
    if (!otherPassed) {
        ++row.otherTask;
        seen += ", other task " + told(other);
    }
    const bool asExpected = rightState && rightName && otherPassed && !own.needsReview;
    if (row.asExpected) row.seen = seen;
    row.asExpected = row.asExpected && asExpected;
}

CatalogueRow runOne(const Mistake& mistake, const std::string& reference, const build::Kit& kit,
                    const sandbox::Sandbox& sandbox, const CatalogueRun& run) {
    const build::Program program = compile(mistake, reference, kit, sandbox);
    const sandbox::Limits limits;
    CatalogueRow row;
    row.entry = mistake;
    row.asExpected = true;
    for (int i = 0; i < run.decisions; ++i) {
        build::SandboxedExaminee examinee{program, sandbox, limits};
        const double before = threadCpuMs();
        count(decision::judgeDistributed(examinee, {}, run.seed + static_cast<std::uint64_t>(i)),
              row);
        row.judgeMs = std::max(row.judgeMs, threadCpuMs() - before);
        row.probeMs = std::max(row.probeMs, examinee.cpuMs());
    }
    return row;
}

/// Decisions of one kind, and how many went wrong.
struct Tally {
    int decisions = 0;
    int wrong = 0;

    // The upper bound of 95 % confidence: the p at which so few or fewer have a chance of 5 %, by
    // bisection on the binomial law.
    [[nodiscard]] double bound() const {
        double low = 0.0;
        double high = 1.0;
        for (int i = 0; i < 60; ++i) {
            const double p = 0.5 * (low + high);
            double term = std::exp(decisions * std::log1p(-p));
            double chance = term;
            for (int k = 1; k <= wrong; ++k) {
                term *= (decisions - k + 1.0) / k * p / (1.0 - p);
                chance += term;
            }
            (chance > 0.05 ? low : high) = p;
        }
        return decisions > 0 ? high : 1.0;
    }
    [[nodiscard]] std::string line(const char* what) const {
        return fmt::format("| {} | {} | {} | {:.2g} |\n", what, decisions, wrong, bound());
    }
};

}  // namespace

std::vector<CatalogueRow> runDistributedCatalogue(const std::vector<Mistake>& catalogue,
                                                  const std::string& reference,
                                                  const build::Kit& kit,
                                                  const sandbox::Sandbox& sandbox,
                                                  const CatalogueRun& run) {
    const std::vector<Mistake> picked = pick(catalogue, run);
    std::vector<CatalogueRow> rows(picked.size());
    std::atomic<std::size_t> next{0};
    std::size_t done = 0;
    std::mutex mutex;
    std::exception_ptr error;
    const auto work = [&] {
        for (std::size_t i = next++; i < picked.size(); i = next++) {
            try {
                rows[i] = runOne(picked[i], reference, kit, sandbox, run);
            } catch (...) {
                const std::lock_guard lock{mutex};
                if (!error) error = std::current_exception();
                return;
            }
            const std::lock_guard lock{mutex};
            if (run.progress) run.progress(++done, picked.size());
        }
    };
    {
        std::vector<std::jthread> helpers;
        for (int i = 1; i < run.jobs; ++i)
            helpers.emplace_back(work);
        work();
    }
    if (error) std::rethrow_exception(error);
    return rows;
}

std::string tableOf(const std::vector<CatalogueRow>& rows) {
    std::string table;
    std::size_t differing = 0;
    for (const CatalogueRow& row : rows) {
        if (!row.asExpected) ++differing;
        table += fmt::format("{} {:<5} {:<34} {:<38} {:4.0f} + {:3.0f} ms{}\n",
                             row.asExpected ? " " : "!", row.entry.task, row.entry.id,
                             told(row.entry.expect), row.probeMs, row.judgeMs,
                             row.asExpected ? "" : "   saw: " + row.seen);
    }
    return table + fmt::format("{} entries, {} not as expected\n", rows.size(), differing);
}

std::string recordOf(const std::vector<CatalogueRow>& rows) {
    Tally accepted;
    Tally reviewed;
    Tally mistakes;
    Tally names;
    Tally others;
    for (const CatalogueRow& row : rows) {
        const bool passes = row.entry.expect.state == TaskState::passed;
        Tally& own = passes ? accepted : mistakes;
        own.decisions += row.decisions;
        own.wrong += row.wrongState;
        if (passes) {
            reviewed.decisions += row.decisions;
            reviewed.wrong += row.reviews;
        } else {
            names.decisions += row.decisions - row.wrongState;
            names.wrong += row.wrongName;
        }
        others.decisions += row.decisions;
        others.wrong += row.otherTask;
    }
    return "| what | decisions | of them | 95 % bound |\n|---|---|---|---|\n" +
           accepted.line("accepted readings that failed") +
           reviewed.line("accepted readings that a person should look at") +
           mistakes.line("mistakes that passed") + names.line("mistakes with another name") +
           others.line("other task blamed");
}

}  // namespace ticker::selftest
