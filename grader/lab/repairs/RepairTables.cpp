#include <grader/lab/repairs/RepairTables.h>

#include <grader/exercise/Exercise.h>
#include <grader/repair/Explain.h>
#include <grader/repair/candidates/Tokens.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace ticker::lab {
namespace {

/// The only task that an entry is expected to fail; empty: none, or several.
std::string failingTask(const corpus::Entry& entry) {
    std::string failing;
    for (const auto& [task, expected] : entry.tasks) {
        const bool fails = std::ranges::find(expected.states, "failed") != expected.states.end() ||
                           expected.finding().starts_with("run.");
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

/// One replacement, in one line of the mistake, of at most eight tokens on either side.
bool isOneEdit(const corpus::Entry& entry, const std::string& right, const std::string& wrong) {
    constexpr std::size_t kMostTokens = 8;
    if (entry.collection != "mistakes" || entry.edits.size() != 1 ||
        entry.edits.begin()->second.size() != 1)
        return false;
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

std::string rightText(const corpus::Entry& entry, const std::string& file) {
    corpus::Entry plain = entry;
    plain.edits = {{file, {}}};
    return corpus::textsOf(plain).at(file);
}

RepairRow tryEntry(const corpus::Entry& entry, const std::string& task,
                   const pipeline::Grader& grader, std::uint64_t seed) {
    intake::Submission submission;
    submission.name = entry.name;
    const auto texts = corpus::textsOf(entry);
    for (const auto& [file, text] : texts)
        submission.parts[file] = text;
    const SubmissionResult result = pipeline::gradeSubmission(submission, grader, seed);
    const repair::Explanation found = repair::explain(submission, grader, result, seed + 1);

    RepairRow row{entry.collection, task, entry.name, false, false, false, found.cpuMs};
    const auto first = std::ranges::find(found.repairs, task, &Repair::task);
    row.isRepaired = first != found.repairs.end();
    if (entry.edits.size() == 1) {
        const std::string file = entry.edits.begin()->first;
        const std::string right = rightText(entry, file);
        row.isOneEdit = isOneEdit(entry, right, texts.at(file));
        row.isRightLine = row.isRepaired && isInside(*first, right, texts.at(file));
    }
    return row;
}

/// Figures of the rows that a line of the table stands for.
struct Sum {
    std::size_t tried = 0;
    std::size_t repaired = 0;
    std::size_t rightLine = 0;
    std::vector<double> cpuMs;

    void add(const RepairRow& row) {
        ++tried;
        repaired += row.isRepaired ? 1 : 0;
        rightLine += row.isRightLine ? 1 : 0;
        cpuMs.push_back(row.cpuMs);
    }
    [[nodiscard]] double quantile(double share) const {
        std::vector<double> sorted = cpuMs;
        std::ranges::sort(sorted);
        const auto last = static_cast<double>(sorted.size() - 1);
        return sorted.empty() ? 0.0 : sorted[static_cast<std::size_t>(share * last + 0.5)];
    }
};

std::string percent(std::size_t part, std::size_t whole) {
    if (whole == 0) return "-";
    return fmt::format("{:.0f} %", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

}  // namespace

std::vector<RepairRow> runRepairs(const std::vector<corpus::Entry>& entries,
                                  const std::string& task, const pipeline::Grader& grader,
                                  const RepairRun& run) {
    std::vector<std::pair<const corpus::Entry*, std::string>> picked;
    double owed = 0.0;
    for (const corpus::Entry& entry : entries) {
        const std::string failing = failingTask(entry);
        if (failing.empty() || (!task.empty() && failing != task)) continue;
        owed += run.fraction;
        if (owed < 1.0) continue;
        owed -= 1.0;
        picked.emplace_back(&entry, failing);
    }
    std::vector<RepairRow> rows;
    for (const auto& [entry, failing] : picked) {
        rows.push_back(tryEntry(*entry, failing, grader, run.seed));
        if (run.progress) run.progress(rows.size(), picked.size());
    }
    return rows;
}

std::string listOf(const std::vector<RepairRow>& rows) {
    std::string text;
    for (const RepairRow& row : rows)
        text += fmt::format("{:9} {:5} {:40} {:9} {:8} {:10} {:5.1f} s\n", row.collection, row.task,
                            row.name, row.isOneEdit ? "one edit" : "",
                            row.isRepaired ? "repaired" : "-", row.isRightLine ? "right line" : "",
                            row.cpuMs / 1000.0);
    return text;
}

std::string tableOf(const std::vector<RepairRow>& rows) {
    std::map<std::pair<std::string, std::string>, Sum> sums;
    for (const RepairRow& row : rows) {
        sums[{row.collection, row.task}].add(row);
        if (row.isOneEdit) sums[{"mistakes of one edit", row.task}].add(row);
    }
    std::string text =
        "| submissions | task | tried | repaired | in the edited line | CPU, median | CPU, 90 % |\n"
        "|---|---|---|---|---|---|---|\n";
    for (const auto& [key, sum] : sums) {
        const bool knowsLine = key.first.starts_with("mistakes");
        text += fmt::format("| {} | {} | {} | {} | {} | {:.1f} s | {:.1f} s |\n", key.first,
                            key.second, sum.tried, percent(sum.repaired, sum.tried),
                            knowsLine ? percent(sum.rightLine, sum.repaired) : "not known",
                            sum.quantile(0.5) / 1000.0, sum.quantile(0.9) / 1000.0);
    }
    return text;
}

std::string documentOf(const std::vector<RepairRow>& rows) {
    return "# Repairs: measured rates\n"
           "Made by `ticker-lab repairs --write docs/repairs.md`. Each wrong submission of the "
           "corpus that fails one\ntask is graded and explained. *Mistakes of one edit* replace at "
           "most eight tokens in one line of the reference.\nA repair counts only if it is proven; "
           "the line is that of the simplest one. CPU is all of the explanation:\nparsing, "
           "compiling, asking, judging, proving.\n\n" +
           tableOf(rows);
}

}  // namespace ticker::lab
