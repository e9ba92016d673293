#include <grader/base/MakeFolder.h>
#include <grader/cli/ClassRun.h>
#include <grader/cli/Output.h>
#include <grader/report/Escape.h>
#include <grader/report/ReportWords.h>
#include <grader/result/Names.h>
#include <grader/store/ClassFolder.h>
#include <grader/store/Earlier.h>

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>

#include <fmt/core.h>
#include <algorithm>
#include <utility>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSeedKey = "seed";
constexpr const char* kExerciseKey = "exercise";

/// A class has one exercise. A store that has results but no exercise belongs to the default one.
void keepToOne(store::Store& store, const Exercise& exercise, const fs::path& out) {
    std::string earlier = store.remembered(kExerciseKey);
    if (earlier.empty() && !store.results().empty()) earlier = defaultExercise().name;
    if (!earlier.empty() && earlier != exercise.name)
        throw raytracer::InputError(
            out.string(), 0,
            fmt::format("holds results of {}; give results of {} another folder with -o", earlier,
                        exercise.name));
    store.remember(kExerciseKey, exercise.name);
}

/// Creates a folder that only its owner can read: it contains students' code and marks. An existing
/// folder keeps its permissions.
void make(const fs::path& out) {
    const fs::path whole = fs::absolute(out).lexically_normal();
    const fs::path folder = whole.has_filename() ? whole : whole.parent_path();
    std::error_code error;
    if (fs::is_directory(folder, error)) return;
    makeFolder(folder);
    fs::permissions(folder, fs::perms::owner_all, error);
    if (error)
        throw raytracer::InputError(out.string(), 0,
                                    "its permissions cannot be set: " + error.message());
}

bool hasFinding(const SubmissionResult& result, const std::string& id) {
    return std::ranges::any_of(result.tasks, [&](const TaskReport& task) {
        return std::ranges::any_of(task.findings,
                                   [&](const Finding& finding) { return finding.id == id; });
    });
}

}  // namespace

bool rememberOrigin(store::Store& store, const std::vector<SubmissionResult>& results) {
    if (results.empty()) return true;
    store.remember(kExerciseKey, exerciseOf(results).name);
    const bool isOne = std::ranges::all_of(results, [&](const SubmissionResult& result) {
        return result.seed == results.front().seed;
    });
    if (isOne) store.remember(kSeedKey, std::to_string(results.front().seed));
    return isOne;
}

bool Regrade::concerns(const SubmissionResult& result) const {
    return std::ranges::any_of(words, [&](const std::string& word) {
        if (word == "all") return true;
        if (word == "older") return result.inputs.tool != build;
        return word == result.submission || hasFinding(result, word);
    });
}

ClassRun::ClassRun(fs::path out, const Exercise& exercise, Regrade regrade, bool hasStore)
    : out_(std::move(out)), regrade_(std::move(regrade)) {
    make(out_);
    if (!hasStore) return;
    lock_.emplace(out_);
    store_.emplace(out_);
    keepToOne(*store_, exercise, out_);
}

std::uint64_t ClassRun::settleSeed(std::optional<std::uint64_t> given, bool keepsResults,
                                   std::uint64_t fresh) {
    if (!store_) return given.value_or(fresh);
    const auto earlier = raytracer::parseCount(store_->remembered(kSeedKey));
    const std::uint64_t seed = given ? *given : keepsResults && earlier ? *earlier : fresh;
    store_->remember(kSeedKey, std::to_string(seed));
    return seed;
}

void ClassRun::checkRegrade(const std::vector<intake::Located>& submissions) const {
    if (regrade_.words.empty()) return;
    const std::vector<store::ResultRow> rows =
        store_ ? store_->results() : std::vector<store::ResultRow>{};
    // Without a store, as on a node of a cluster, the results themselves say what was found.
    const auto isFoundIn = [&](const intake::Located& located, const std::string& id) {
        const auto result = store::readWholeResult(out_, located.name);
        return result && hasFinding(*result, id);
    };
    for (const std::string& word : regrade_.words) {
        const bool isMeant =
            word == "all" || word == "older" ||
            std::ranges::find(submissions, word, &intake::Located::name) != submissions.end() ||
            std::ranges::any_of(rows,
                                [&](const store::ResultRow& row) {
                                    return std::ranges::find(row.findings, word) !=
                                           row.findings.end();
                                }) ||
            (!store_ && std::ranges::any_of(submissions, [&](const intake::Located& located) {
                return isFoundIn(located, word);
            }));
        if (!isMeant)
            throw raytracer::InputError(
                "", 0,
                fmt::format("--regrade {}: no submission here has this name, and none in {} this "
                            "finding; expected one, or all, or older",
                            word, out_.string()));
    }
}

std::optional<SubmissionResult> ClassRun::known(const std::string& submission,
                                                const Inputs& inputs) const {
    std::optional<SubmissionResult> result = store::readWholeResult(out_, submission);
    if (!result || result->verdict == Verdict::notGraded || !result->inputs.areKnown())
        return std::nullopt;
    const bool holds = regrade_.words.empty()
                           ? result->inputs == inputs
                           : result->inputs.files == inputs.files && !regrade_.concerns(*result);
    return holds ? std::move(result) : std::nullopt;
}

void ClassRun::write(const SubmissionResult& result) const {
    if (!store::keepsBefore(out_, result)) writeSubmission(out_, result);
}

Stored ClassRun::index(const SubmissionResult& result, bool isKept) {
    if (!isKept && store::keepsBefore(out_, result)) return Stored::before;
    const bool isKnown =
        isKept && store_ && store::isKnown(store_->find(result.submission), result);
    if (store_ && !isKnown) store_->put(result, store::utcNow());
    return isKept ? Stored::kept : Stored::fresh;
}

std::size_t RunCounts::all() const {
    std::size_t sum = 0;
    for (const auto& [verdict, count] : verdicts)
        sum += count;
    return sum;
}

std::string closingLine(const RunCounts& counts) {
    std::string line = report::counted(counts.all(), "submission") + ":";
    for (const auto& [verdict, count] : counts.verdicts)
        line += fmt::format(" {} {}", count, toString(verdict));
    if (counts.kept > 0)
        line += fmt::format("\n{} kept from before: their inputs have not changed", counts.kept);
    return line;
}

std::string notAnewLine(const RunCounts& counts) {
    if (counts.notAnew.empty()) return {};
    constexpr std::size_t kMostNames = 10;
    std::string names;
    for (std::size_t i = 0; i < std::min(counts.notAnew.size(), kMostNames); ++i)
        names += (i == 0 ? "" : ", ") + report::escapeLine(counts.notAnew[i]);
    if (counts.notAnew.size() > kMostNames) names += ", ...";
    return fmt::format(
        "{} could not be graded anew ({}), and the earlier result of the same files stays. Why: "
        "{}. "
        "The same command tries again",
        report::counted(counts.notAnew.size(), "submission"), names,
        report::escapeLine(counts.whyNotAnew));
}

raytracer::ExitCode exitCodeOf(const RunCounts& counts, bool stopped) {
    if (stopped) return raytracer::ExitCode::interrupted;
    if (counts.verdicts.contains(Verdict::notGraded)) return raytracer::ExitCode::notGradable;
    return counts.unexpected > 0 ? raytracer::ExitCode::checkFailed : raytracer::ExitCode::success;
}

}  // namespace ticker::cli
