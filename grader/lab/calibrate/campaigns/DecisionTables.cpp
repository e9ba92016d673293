#include <grader/lab/calibrate/BlockRecord.h>
#include <grader/lab/calibrate/RateBounds.h>
#include <grader/lab/calibrate/campaigns/DecisionTables.h>

#include <fmt/core.h>

#include <algorithm>

namespace ticker::calibrate {
namespace {

using Histogram = std::map<int, std::size_t>;

/// Blocks of one or many subjects, added up.
struct Tally {
    std::size_t decisions = 0;
    std::size_t wrongState = 0;
    std::size_t wrongName = 0;
    std::size_t reviews = 0;
    std::size_t passed = 0;  // in the wrong state, less the block's reviews
    std::map<std::string, std::size_t> seen;
    Histogram cpu;  // of one task

    [[nodiscard]] bool isAsExpected() const {
        return wrongState == 0 && wrongName == 0 && reviews == 0;
    }
    void add(const BlockRecord& block) {
        decisions += block.decisions;
        addResults(block);
        addCpu(block);
    }
    void addResults(const BlockRecord& block) {
        wrongState += block.wrongState;
        wrongName += block.wrongName;
        reviews += block.reviews;
        passed += block.wrongState - std::min(block.wrongState, block.reviews);
        for (const auto& [id, times] : block.seen)
            seen[id] += times;
    }
    void addCpu(const BlockRecord& block) {
        for (const auto& [ms, times] : block.cpu)
            cpu[ms] += times;
    }
    void add(const Tally& other) {
        decisions += other.decisions;
        wrongState += other.wrongState;
        wrongName += other.wrongName;
        reviews += other.reviews;
        passed += other.passed;
        for (const auto& [ms, times] : other.cpu)
            cpu[ms] += times;
    }
};

int quantile(const Histogram& histogram, double share) {
    std::size_t all = 0;
    for (const auto& [ms, times] : histogram)
        all += times;
    std::size_t below = 0;
    for (const auto& [ms, times] : histogram) {
        below += times;
        if (static_cast<double>(below) >= share * static_cast<double>(all)) return ms;
    }
    return 0;
}

std::string cpuLine(const char* what, const Histogram& histogram) {
    if (histogram.empty()) return "";
    return fmt::format("| {} | {} | {} | {} | {} |\n", what, quantile(histogram, 0.5),
                       quantile(histogram, 0.9), quantile(histogram, 0.99),
                       histogram.rbegin()->first);
}

std::string boundLine(const char* what, std::size_t hits, std::size_t count) {
    return fmt::format("| {} | {} | {} | {:.2g} |\n", what, count, hits, upperBound(hits, count));
}

std::string listOf(const std::map<std::string, std::size_t>& seen) {
    std::string text;
    for (const auto& [id, times] : seen)
        text += fmt::format("{}{} {} x", text.empty() ? "" : ", ", id, times);
    return text;
}

/// Sums over all subjects, and over those of a kind.
struct Sums {
    Tally all;
    Tally unseen;
    Tally seen;
    Tally statistical;
    Tally races;
    Tally exact;

    Tally& kindOf(const Subject& subject) {
        if (subject.isDataRace()) return races;
        return subject.isStatistical() ? statistical : exact;
    }
};

constexpr std::size_t kCaughtForOneOtherName = 50;

Summary rightTables(const Sums& sums, const std::string& rows) {
    const Tally& all = sums.all;
    Summary summary;
    summary.asExpected = all.wrongState == 0 && 1000 * all.reviews <= all.decisions;
    summary.text =
        "| what | decisions | times | 95 % bound |\n|---|---|---|---|\n" +
        boundLine("right ones that failed", all.wrongState, all.decisions) +
        boundLine("right ones that a person should look at", all.reviews, all.decisions) +
        boundLine("right ones with another finding than expected", all.wrongName, all.decisions) +
        boundLine("of these, whose rays cannot be seen: failed", sums.unseen.wrongState,
                  sums.unseen.decisions) +
        boundLine("likewise: to be looked at", sums.unseen.reviews, sums.unseen.decisions) +
        "\nCPU of one task's verdict, submission and judgement together, without compiling, ms:\n\n"
        "| which | median | 90 % | 99 % | most |\n|---|---|---|---|---|\n" +
        cpuLine("all", all.cpu) + cpuLine("rays seen", sums.seen.cpu) +
        cpuLine("rays not seen, oracle shared", sums.unseen.cpu) + rows;
    return summary;
}

Summary wrongTables(const Sums& sums, const std::string& rows) {
    const Tally& all = sums.all;
    Summary summary;
    const std::size_t caught = all.decisions - all.wrongState;
    summary.asExpected = all.wrongState == 0 && kCaughtForOneOtherName * all.wrongName <= caught;
    summary.text =
        "| what | decisions | times | 95 % bound |\n|---|---|---|---|\n" +
        boundLine("exact mistakes that passed", sums.exact.passed, sums.exact.decisions) +
        boundLine("data races that passed", sums.races.passed, sums.races.decisions) +
        boundLine("mistakes of a distribution that passed", sums.statistical.passed,
                  sums.statistical.decisions) +
        boundLine("of these, whose rays cannot be seen", sums.unseen.passed,
                  sums.unseen.decisions) +
        boundLine("not caught, but for a person", all.wrongState - all.passed, all.decisions) +
        boundLine("caught, but with another name", all.wrongName, caught) +
        "\nCPU of one task's verdict, submission and judgement together, without compiling, ms:\n\n"
        "| which | median | 90 % | 99 % | most |\n|---|---|---|---|---|\n" +
        cpuLine("all", all.cpu) + cpuLine("rays seen", sums.seen.cpu) +
        cpuLine("rays not seen, oracle shared", sums.unseen.cpu) + rows;
    return summary;
}

std::string rightRow(const Subject& subject, const Tally& tally) {
    return fmt::format("| {} | {} | {} | {} | {} |\n", subject.name, tally.decisions,
                       tally.wrongState, tally.reviews, listOf(tally.seen));
}

std::string wrongRow(const Subject& subject, const Tally& tally) {
    const std::size_t caught = tally.decisions - tally.wrongState;
    const double named = caught == 0 ? 0.0
                                     : 100.0 * static_cast<double>(caught - tally.wrongName) /
                                           static_cast<double>(caught);
    return fmt::format("| {} | {} | {} | {:.2g} | {:.1f} % | {} |\n", subject.name, tally.decisions,
                       tally.passed, upperBound(tally.passed, tally.decisions), named,
                       listOf(tally.seen));
}

// Adds up the blocks of each subject; key: its name.
std::map<std::string, Tally> talliesOf(const std::vector<Subject>& subjects,
                                       const std::vector<std::string>& records) {
    std::map<std::string, const Subject*> byName;
    for (const Subject& subject : subjects)
        byName.emplace(subject.name, &subject);
    std::map<std::string, Tally> tallies;
    for (const std::string& text : records) {
        const BlockRecord block = BlockRecord::parse(text);
        const Subject& subject = *byName.at(block.subject);
        Tally& tally = tallies[block.subject];
        // The other tasks of a subject belong to the same decision, which is counted once.
        if (block.task == subject.ownTask())
            tally.add(block);
        else
            tally.addResults(block);
        if (block.task != subject.ownTask() && subject.task.empty()) tally.addCpu(block);
    }
    return tallies;
}

}  // namespace

Summary tablesOf(const std::vector<Subject>& subjects, const std::vector<std::string>& records) {
    std::map<std::string, Tally> tallies = talliesOf(subjects, records);
    Sums sums;
    std::string rows;
    std::size_t asExpected = 0;
    bool right = true;
    for (const Subject& subject : subjects) {
        const Tally& tally = tallies[subject.name];
        sums.all.add(tally);
        (subject.isUnseen() ? sums.unseen : sums.seen).add(tally);
        sums.kindOf(subject).add(tally);
        right = subject.isRight();
        if (tally.decisions == 0) continue;
        if (tally.isAsExpected())
            ++asExpected;
        else
            rows += right ? rightRow(subject, tally) : wrongRow(subject, tally);
    }
    if (!rows.empty())
        rows =
            (right ? "\n| right one | decisions | failed | to be looked at | saw instead |\n"
                     "|---|---|---|---|---|\n"
                   : "\n| mistake | decisions | passed | 95 % bound | right name | saw instead |\n"
                     "|---|---|---|---|---|---|\n") +
            rows;
    rows += fmt::format("\n{} {} had the expected result in every decision.\n", asExpected,
                        right ? "right ones" : "mistakes");
    return right ? rightTables(sums, rows) : wrongTables(sums, rows);
}

Summary exactTables(const std::vector<Subject>& subjects, const std::vector<std::string>& records) {
    struct Row {
        Tally right;
        Tally wrong;
    };
    std::map<std::string, bool> isRight;
    for (const Subject& subject : subjects)
        isRight.emplace(subject.name, subject.isRight());
    std::map<std::string, Row> rows;
    for (const std::string& text : records) {
        const BlockRecord block = BlockRecord::parse(text);
        Row& row = rows[block.task];
        (isRight.at(block.subject) ? row.right : row.wrong).add(block);
    }
    Summary summary;
    summary.text =
        "| task | right ones judged | failed or with another finding | mistakes judged | passed | "
        "another name |\n|---|---|---|---|---|---|\n";
    for (const auto& [task, row] : rows) {
        const std::size_t failed = row.right.wrongState + row.right.wrongName;
        summary.text +=
            fmt::format("| {} | {} | {} | {} | {} | {} |\n", task, row.right.decisions, failed,
                        row.wrong.decisions, row.wrong.wrongState, row.wrong.wrongName);
        summary.asExpected =
            summary.asExpected && failed + row.wrong.wrongState + row.wrong.wrongName == 0;
    }
    return summary;
}

}  // namespace ticker::calibrate
