#include <grader/cli/verbs/StudentPages.h>

#include <grader/base/WholeFile.h>
#include <grader/cli/Home.h>
#include <grader/cli/Output.h>
#include <grader/report/Escape.h>
#include <grader/report/ReportWords.h>
#include <grader/report/student/StudentPage.h>
#include <grader/result/ResultJson.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>

#include <cstdio>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

/// The valid result: the ticker's decision, or the tool's proposal.
SubmissionResult decided(const store::ClassEntry& entry) {
    SubmissionResult result = entry.result;
    if (!isDecided(entry)) return result;
    const bool isAwarded = entry.decision->ruling == Ruling::awarded;
    result.verdict = isAwarded ? Verdict::awarded : Verdict::notAwarded;
    if (!isAwarded)
        result.score = 0.0;
    else if (result.score <= 0.0)
        result.score = result.maxScore;
    return result;
}

report::StudentView viewOf(const SubmissionResult& result, const store::ClassEntry& entry,
                           const report::StudentPolicy& policy) {
    const Decision decision = entry.decision.value_or(Decision{});
    return {result, policy, decision.comment, entry.result.verdict, decision.notes};
}

}  // namespace

void addStudentView(CLI::App& verb, std::string& file) {
    verb.add_option("--student-view", file,
                    "What students may see, instead of the kit's own policy");
}

report::StudentPolicy policyFrom(const std::string& file) {
    return report::readStudentPolicy(file.empty() ? Home::find().studentView() : fs::path{file});
}

bool isDecided(const store::ClassEntry& entry) {
    return entry.decision && entry.decision->ruling != Ruling::undecided;
}

bool isStale(const store::ClassEntry& entry) {
    return isDecided(entry) && !entry.decision->files.empty() &&
           entry.decision->files != entry.result.inputs.files;
}

void warnOfStale(const std::vector<store::ClassEntry>& entries, bool decidedOnly) {
    constexpr std::size_t kMostNames = 10;
    std::size_t count = 0;
    std::string names;
    for (const store::ClassEntry& entry : entries) {
        if (!isStale(entry)) continue;
        const std::string name = report::escapeLine(entry.result.submission);
        if (count < kMostNames) names += (names.empty() ? "" : ", ") + name;
        if (count == kMostNames) names += ", ...";
        ++count;
    }
    if (count == 0) return;
    fmt::print(
        stderr,
        "ticker: {} {} about an earlier hand-in ({}); look at {} in a session (Show: changed "
        "since decided) before you upload{}\n",
        report::counted(count, "decision"), count == 1 ? "is" : "are", names,
        count == 1 ? "it" : "them", decidedOnly ? "; --decided-only leaves their marks out" : "");
}

report::StudentView studentViewOf(const store::ClassEntry& entry,
                                  const report::StudentPolicy& policy) {
    return viewOf(decided(entry), entry, policy);
}

std::string studentPageOf(const fs::path& out, const store::ClassEntry& entry,
                          const report::StudentPolicy& policy) {
    SubmissionResult result = decided(entry);
    fetchFiles(out, result);
    if (entry.decision)
        for (const LineNote& note : entry.decision->notes)
            fetchSource(out, note.file, result);
    return report::studentPage(viewOf(result, entry, policy));
}

std::vector<fs::path> writeStudentPages(const fs::path& out,
                                        const std::vector<store::ClassEntry>& entries,
                                        const std::string& studentView) {
    const report::StudentPolicy policy = policyFrom(studentView);
    std::vector<fs::path> written;
    for (const store::ClassEntry& entry : entries) {
        written.push_back(out / entry.result.submission / "student.html");
        writeAtomically(studentPageOf(out, entry, policy), written.back());
    }
    return written;
}

}  // namespace ticker::cli
