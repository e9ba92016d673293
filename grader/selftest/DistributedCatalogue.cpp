#include <grader/build/Build.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/decision/distributed/JudgeDistributed.h>
#include <grader/selftest/DistributedCatalogue.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <iterator>
#include <mutex>
#include <thread>

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

CatalogueRow runOne(const Mistake& mistake, const std::string& reference, const build::Kit& kit,
                    const sandbox::Sandbox& sandbox, const CatalogueRun& run) {
    const sandbox::Limits limits;
    const build::BuildResult built =
        build::buildProgram(kit, sandbox, limits, build::SourceFile::renderer,
                            mistakes::makeMistake(mistake, reference));
    if (!built.program)
        throw raytracer::Error(
            fmt::format("{} does not compile: {}", mistake.path, built.diagnostics));

    CatalogueRow row;
    row.entry = mistake;
    row.asExpected = true;
    for (int i = 0; i < run.decisions && row.asExpected; ++i) {
        build::SandboxedExaminee examinee{*built.program, sandbox, limits};
        const decision::DistributedJudgement judgement =
            decision::judgeDistributed(examinee, {}, run.seed + static_cast<std::uint64_t>(i));
        const bool shadows = mistake.task == "T2.1";
        const TaskJudgement& own = shadows ? judgement.softShadows : judgement.depthOfField;
        const TaskJudgement& other = shadows ? judgement.depthOfField : judgement.softShadows;
        row.seen = told(own);
        if (told(other) != "passed") row.seen += ", other task " + told(other);
        row.asExpected = row.seen == told(mistake.expect);
        row.cpuMs = std::max(row.cpuMs, examinee.cpuMs());
    }
    return row;
}

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
        table += fmt::format("{} {:<5} {:<34} {:<38} {:6.0f} ms{}\n", row.asExpected ? " " : "!",
                             row.entry.task, row.entry.id, told(row.entry.expect), row.cpuMs,
                             row.asExpected ? "" : "   saw: " + row.seen);
    }
    return table + fmt::format("{} entries, {} not as expected\n", rows.size(), differing);
}

}  // namespace ticker::selftest
