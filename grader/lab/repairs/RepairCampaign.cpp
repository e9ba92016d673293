#include <grader/lab/EvenShare.h>
#include <grader/lab/repairs/RepairCampaign.h>

#include <grader/repair/Explain.h>
#include <grader/repair/candidates/Tokens.h>
#include <grader/result/GeneralFindings.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ticker::lab {
namespace {

/// The only task that an entry is expected to fail; empty: none, or several.
std::string failingTask(const corpus::Entry& entry) {
    std::string failing;
    for (const auto& [task, expected] : entry.tasks) {
        const bool fails = std::ranges::find(expected.states, "failed") != expected.states.end() ||
                           isRunEnd(expected.finding());
        if (!fails || task == kScreenshotTask) continue;
        if (!failing.empty()) return "";
        failing = task;
    }
    return failing;
}

std::size_t tokensIn(std::string_view text) {
    return candidates::tokensOf(text).size();
}

/// Where two texts differ: from the first differing byte to the last, as a range of the second.
candidates::Range difference(std::string_view a, std::string_view b) {
    std::size_t front = 0;
    while (front < a.size() && front < b.size() && a[front] == b[front])
        ++front;
    std::size_t back = 0;
    while (back + front < a.size() && back + front < b.size() &&
           a[a.size() - 1 - back] == b[b.size() - 1 - back])
        ++back;
    return {front, b.size() - back};
}

std::string rightText(const corpus::Entry& entry, const std::string& file) {
    corpus::Entry plain = entry;
    plain.edits = {{file, {}}};
    return corpus::textsOf(plain).at(file);
}

/// Whether an entry is a mistake of one replacement, which puts at most eight tokens of one line in
/// place of at most eight.
bool isOneEdit(const corpus::Entry& entry) {
    constexpr std::size_t kMostTokens = 8;
    if (!entry.collection.ends_with("mistakes") || entry.edits.size() != 1 ||
        entry.edits.begin()->second.size() != 1)
        return false;
    const std::string& file = entry.edits.begin()->first;
    const std::string right = rightText(entry, file);
    const std::string wrong = corpus::textsOf(entry).at(file);
    const candidates::Range place = difference(right, wrong);
    const candidates::Range was = difference(wrong, right);
    const std::string_view put = std::string_view{wrong}.substr(place.begin, place.size());
    const std::string_view taken = std::string_view{right}.substr(was.begin, was.size());
    return put.find('\n') == std::string_view::npos && tokensIn(put) <= kMostTokens &&
           tokensIn(taken) <= kMostTokens;
}

int lineAt(std::string_view text, std::size_t offset) {
    return 1 + static_cast<int>(std::ranges::count(text.substr(0, offset), '\n'));
}

bool isInside(const Repair& repair, std::string_view right, std::string_view wrong) {
    const candidates::Range place = difference(right, wrong);
    const int first = lineAt(wrong, place.begin);
    const int last = lineAt(wrong, place.end);
    return std::ranges::all_of(repair.edits, [&](const RepairEdit& edit) {
        return edit.line >= first && edit.line <= last;
    });
}

std::string blankless(std::string_view text) {
    std::string words;
    for (const candidates::Range& token : candidates::tokensOf(text))
        words += std::string{words.empty() ? "" : " "} +
                 std::string{text.substr(token.begin, token.size())};
    return words;
}

double cpuOf(const repair::Explanation& found, repair::Work work) {
    const auto ms = found.workMs.find(work);
    return ms == found.workMs.end() ? 0.0 : ms->second;
}

/// A repair in words: "line 40: a + b -> a - b", and the finding that is left, if any.
std::string inWords(const Repair& repair) {
    std::string words;
    for (const RepairEdit& edit : repair.edits)
        words += fmt::format("{}line {}: {} -> {}", words.empty() ? "" : "; ", edit.line,
                             blankless(edit.from), blankless(edit.to));
    return repair.next.empty() ? words : words + " (next: " + repair.next + ")";
}

}  // namespace

RepairCampaign::RepairCampaign(const pipeline::Grader& grader,
                               const std::vector<corpus::Entry>& entries,
                               const RepairChoice& choice, std::uint64_t seed)
    : grader_(grader), judge_(grader), seed_(seed) {
    judge_.scenes.clear();
    for (const corpus::Entry& entry : entries) {
        const std::string failing = failingTask(entry);
        if (failing.empty() || (!choice.task.empty() && failing != choice.task)) continue;
        const bool isNamed = std::ranges::find(choice.cases, entry.name) != choice.cases.end();
        if (!choice.cases.empty() && !isNamed) continue;
        const bool isCatalogued = entry.collection.ends_with("mistakes");
        if (choice.ofOneEdit && isCatalogued && !isOneEdit(entry)) continue;
        units_.push_back({entry, failing});
    }
    units_ = evenShare(std::move(units_), choice.fraction, 0.0);
}

std::string RepairCampaign::nameOf(std::size_t unit) const {
    const Unit& one = units_.at(unit);
    RepairRow row;
    row.collection = one.entry.collection;
    row.task = one.task;
    row.name = one.entry.name;
    return lab::nameOf(row);
}

RepairRow RepairCampaign::run(std::size_t unit) const {
    const auto& [entry, task] = units_.at(unit);
    intake::Submission submission;
    submission.name = entry.name;
    const auto texts = corpus::textsOf(entry);
    for (const auto& [file, text] : texts)
        submission.parts[file] = text;
    const SubmissionResult result = pipeline::gradeSubmission(submission, judge_, seed_);
    // The limit on CPU time counts here; on a busy machine, the one on wall-clock time must not end
    // the search.
    constexpr double kLongWall = 3600.0;
    repair::SearchLimits limits = repair::defaultSearchLimits();
    limits.all.wallSeconds = kLongWall;
    const repair::Explanation found =
        repair::explain(submission, grader_, result, seed_ + 1, limits);

    RepairRow row;
    row.collection = entry.collection;
    row.task = task;
    row.name = entry.name;
    row.cpuMs = found.cpuMs;
    row.parseMs = cpuOf(found, repair::Work::parse);
    row.compileMs = cpuOf(found, repair::Work::compile);
    row.askMs = cpuOf(found, repair::Work::ask);
    row.proveMs = cpuOf(found, repair::Work::prove);
    row.tried = found.tried;
    row.wasCutOff = !found.cutOff.empty();
    const auto first = std::ranges::find(found.repairs, task, &Repair::task);
    row.isRepaired = first != found.repairs.end() && first->next.empty();
    if (first != found.repairs.end()) row.edit = inWords(*first);
    if (entry.edits.size() == 1) {
        const std::string file = entry.edits.begin()->first;
        const std::string right = rightText(entry, file);
        row.isOneEdit = isOneEdit(entry);
        row.isRightLine = row.isRepaired && isInside(*first, right, texts.at(file));
    }
    return row;
}

}  // namespace ticker::lab
