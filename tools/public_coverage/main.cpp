// public_coverage [--only TEXT] [--fraction F] [--write FILE]: which known mistakes the public
// tests notice, and whether they pass every right solution. Exit status 1 if a right solution
// fails.
#include "Case.h"
#include "Examine.h"

#include <grader/base/WholeFile.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <unistd.h>
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace ticker::coverage {
namespace {

struct Arguments {
    std::string only;  ///< cases whose name contains it
    double fraction = 1.0;
    std::string write;
};

struct Row {
    Case one;
    Outcome outcome;
};

Arguments parse(const std::vector<std::string>& words) {
    Arguments arguments;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool last = i + 1 == words.size();
        if (words[i] == "--fraction" && !last)
            arguments.fraction = std::strtod(words[++i].c_str(), nullptr);
        else if (words[i] == "--only" && !last)
            arguments.only = words[++i];
        else if (words[i] == "--write" && !last)
            arguments.write = words[++i];
        else
            throw raytracer::InputError(
                "", 0, "usage: public_coverage [--only TEXT] [--fraction F] [--write FILE]");
    }
    return arguments;
}

std::vector<Case> pick(std::vector<Case> cases, const Arguments& arguments) {
    std::vector<Case> picked;
    double owed = 0.5;
    for (Case& one : cases) {
        if (one.name.find(arguments.only) == std::string::npos) continue;
        owed += arguments.fraction;
        if (owed < 1.0) continue;
        owed -= 1.0;
        picked.push_back(std::move(one));
    }
    return picked;
}

/// Prints the progress on a terminal.
void showProgress(std::size_t done, std::size_t of) {
    if (isatty(STDERR_FILENO) == 0) return;
    fmt::print(stderr, "\r{} of {}{}", done, of, done == of ? "\n" : "");
    std::fflush(stderr);
}

std::vector<Row> examineAll(std::vector<Case> cases) {
    const Examiner examiner{TICKER_SOURCE_DIR, TICKER_LINK_FILE};
    std::vector<Row> rows(cases.size());
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> done{0};
    std::exception_ptr error;
    std::atomic<bool> failed{false};
    const auto work = [&] {
        for (std::size_t i = next++; i < rows.size() && !failed; i = next++) {
            try {
                rows[i] = {cases[i], examiner.examine(cases[i])};
                showProgress(++done, rows.size());
            } catch (...) {
                if (!failed.exchange(true)) error = std::current_exception();
            }
        }
    };
    {
        const std::jthread helper{work};
        work();
    }
    if (error) std::rethrow_exception(error);
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

std::string tableOf(const std::vector<Row>& rows, const std::string& task) {
    std::string table = fmt::format(
        "### {}\n\n| mistake | what it is | first failing test |\n"
        "|---|---|---|\n",
        task);
    for (const Row& row : rows)
        if (row.one.task == task && !row.one.right)
            table +=
                fmt::format("| {} | {} | {} |\n", row.one.name, row.one.title, saidOf(row.outcome));
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

/// Writes the text between the marks of a Markdown file.
void write(const std::string& text, const std::string& file) {
    const std::string begin = "<!-- public_coverage begin -->\n";
    const std::string end = "<!-- public_coverage end -->";
    std::string page = readWhole(file);
    const std::size_t from = page.find(begin);
    const std::size_t to = page.find(end);
    if (from == std::string::npos || to == std::string::npos || to < from)
        throw raytracer::InputError(file, 0, "expected the lines " + begin + " and " + end);
    page.replace(from + begin.size(), to - from - begin.size(), text);
    std::ofstream{file} << page;
}

int run(const Arguments& arguments) {
    const std::vector<Row> rows = examineAll(pick(listCases(TICKER_SOURCE_DIR), arguments));
    std::string text = summaryOf(rows) + "\n";
    for (const char* task : {"T1", "T2.1", "T2.2", "T2"})
        text += tableOf(rows, task);
    if (arguments.write.empty())
        fmt::print("{}", text);
    else
        write(text, arguments.write);
    int status = 0;
    for (const Row& row : rows) {
        if (!row.one.right || !row.outcome.objects()) continue;
        fmt::print(stderr, "{} {} is right, and refused: {}\n", row.one.task, row.one.name,
                   saidOf(row.outcome));
        status = 1;
    }
    return status;
}

}  // namespace
}  // namespace ticker::coverage

int main(int argc, char** argv) {
    try {
        return ticker::coverage::run(ticker::coverage::parse({argv + 1, argv + argc}));
    } catch (const raytracer::Error& error) {
        fmt::print(stderr, "public_coverage: {}\n", error.what());
        return raytracer::toInt(error.exitCode());
    } catch (const std::exception& error) {
        fmt::print(stderr, "public_coverage: {}\n", error.what());
        return 3;
    }
}
