#include <grader/lab/coverage/CoverageTables.h>

#include <grader/base/Workers.h>
#include <grader/lab/EvenShare.h>
#include <grader/lab/coverage/PublicCase.h>
#include <grader/lab/coverage/PublicExaminer.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <utility>

namespace ticker::coverage {
namespace {

struct Row {
    Case one;
    Outcome outcome;
};

std::vector<Case> pick(std::vector<Case> cases, const CoverageRun& run) {
    std::erase_if(cases,
                  [&](const Case& one) { return one.name.find(run.only) == std::string::npos; });
    if (cases.empty())
        throw raytracer::InputError("--only " + run.only, 0,
                                    "no case has this in its name; nothing is written");
    return lab::evenShare(std::move(cases), run.fraction, 0.5);
}

std::vector<Row> examineAll(const std::filesystem::path& root, std::vector<Case> cases,
                            const CoverageRun& run) {
    const Examiner examiner{root, *run.exercise};
    std::vector<Row> rows(cases.size());
    std::mutex mutex;
    std::size_t done = 0;
    onWorkers(run.jobs, rows.size(), [&](std::size_t i) {
        rows[i] = {cases[i], examiner.examine(cases[i])};
        const std::lock_guard lock{mutex};
        if (run.progress) run.progress(++done, rows.size());
    });
    return rows;
}

std::string inWords(const std::string& testName) {
    std::string text;
    for (const char c : testName) {
        const bool capital = c >= 'A' && c <= 'Z';
        if (capital && !text.empty()) text += ' ';
        text += capital ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return text;
}

std::string saidOf(const Outcome& outcome) {
    switch (outcome.kind) {
        case Outcome::Kind::doesNotCompile:
            return "does not compile";
        case Outcome::Kind::crashed:
            return "crashes or never ends";
        case Outcome::Kind::notAttempted:
            return "not attempted";
        case Outcome::Kind::ran:
            break;
    }
    if (outcome.failed.empty()) return "**not covered**";
    const std::size_t more = outcome.failed.size() - 1;
    return inWords(outcome.failed.front()) + (more > 0 ? fmt::format(" (and {} more)", more) : "");
}

// A bar ends a cell of a Markdown table.
std::string inCell(const std::string& text) {
    std::string cell;
    for (const char c : text)
        cell += c == '|' ? "\\|" : std::string(1, c);
    return cell;
}

std::string tableOf(const std::vector<Row>& rows, const std::string& task) {
    std::string table = fmt::format(
        "### {}\n\n| mistake | what it is | first failing test |\n"
        "|---|---|---|\n",
        task);
    for (const Row& row : rows)
        if (row.one.task == task && !row.one.right)
            table += fmt::format("| {} | {} | {} |\n", row.one.name, inCell(row.one.title),
                                 saidOf(row.outcome));
    return table + "\n";
}

std::string summaryOf(const std::vector<Row>& rows) {
    const auto count = [&](auto&& wanted) { return std::ranges::count_if(rows, wanted); };
    const auto right = count([](const Row& row) { return row.one.right; });
    const auto refused =
        count([](const Row& row) { return row.one.right && row.outcome.objects(); });
    const auto wrong = std::ssize(rows) - right;
    const auto noticed =
        count([](const Row& row) { return !row.one.right && row.outcome.objects(); });
    return fmt::format(
        "Of {} known mistakes the public tests notice {}; of {} right solutions and "
        "accepted readings they refuse {}.\n",
        wrong, noticed, right, refused);
}

/// Headings of the tables: the ids of the tasks, then the options that are not named after a task.
std::vector<std::string> headingsOf(const Exercise& exercise) {
    std::vector<std::string> headings;
    for (const TaskEntry& task : exercise.tasks)
        headings.push_back(task.id);
    for (const OptionEntry& option : exercise.options)
        if (exercise.task(option.name) == nullptr) headings.push_back(option.name);
    return headings;
}

}  // namespace

Coverage measure(const std::filesystem::path& root, const CoverageRun& run) {
    const std::vector<Row> rows = examineAll(root, pick(listCases(root, *run.exercise), run), run);
    Coverage coverage;
    coverage.text = summaryOf(rows) + "\n";
    for (const std::string& heading : headingsOf(*run.exercise))
        coverage.text += tableOf(rows, heading);
    for (const Row& row : rows)
        if (row.one.right && row.outcome.objects())
            coverage.refused.push_back(fmt::format("{} {} is right, and refused: {}", row.one.task,
                                                   row.one.name, saidOf(row.outcome)));
    return coverage;
}

}  // namespace ticker::coverage
