#include <grader/lab/selftest/ScreenshotTables.h>

#include <grader/lab/EvenShare.h>
#include <grader/lab/selftest/ScreenshotCases.h>

#include <fmt/core.h>

#include <algorithm>

namespace ticker::selftest {
namespace {

using Case = ScreenshotCase;

std::string told(const TaskJudgement& judgement) {
    for (const Finding& finding : judgement.findings)
        if (finding.severity != Severity::note) return finding.id;
    return judgement.needsReview ? "a person should look" : "";
}

void judge(const Case& one, std::vector<ScreenshotRow>& rows, ScreenshotSelfTest& result) {
    if (rows.empty() || rows.back().kind != one.kind || rows.back().expected != one.expected)
        rows.push_back({one.kind, one.expected, 0, 0, 0.0});
    ScreenshotRow& row = rows.back();
    double judgeMs = 0.0;
    const TaskJudgement judgement = one.judge(judgeMs);
    row.judgeMs = (row.judgeMs * row.judged + judgeMs) / (row.judged + 1);
    ++row.judged;
    const std::string seen = told(judgement);
    if (seen == one.expected) {
        ++row.asExpected;
        return;
    }
    result.surprises.push_back(fmt::format(
        "{}, {}: expected {}, saw {}: {}", one.kind, one.name,
        one.expected.empty() ? "nothing" : one.expected, seen.empty() ? "nothing" : seen,
        judgement.findings.empty() ? judgement.reason : judgement.findings.front().message));
}

std::string linesOf(const std::vector<ScreenshotRow>& rows) {
    std::string text;
    for (const ScreenshotRow& row : rows)
        text += fmt::format("{} {:<42} {:<30} {:3} of {:3} {:6.0f} ms\n",
                            row.asExpected == row.judged ? " " : "!", row.kind,
                            row.expected.empty() ? "nothing above a note" : row.expected,
                            row.asExpected, row.judged, row.judgeMs);
    return text;
}

}  // namespace

std::string ScreenshotSelfTest::table() const {
    std::string text = "honest pictures\n" + linesOf(honest) + "other pictures\n" + linesOf(bad);
    for (const std::string& surprise : surprises)
        text += "! " + surprise + "\n";
    return text;
}

ScreenshotSelfTest runScreenshotTables(const ScreenshotBench& bench, const ScreenshotRun& run) {
    constexpr double kOwed = 0.5;
    std::vector<Case> honest =
        lab::evenShare(honestScreenshots(bench, run.seed), run.fraction, kOwed);
    const std::vector<Case> bad =
        lab::evenShare(badScreenshots(bench, run.seed), run.fraction, kOwed);
    std::ranges::stable_sort(honest, {}, &Case::kind);
    ScreenshotSelfTest result;
    std::size_t done = 0;
    const auto judgeAll = [&](const std::vector<Case>& some, std::vector<ScreenshotRow>& rows) {
        for (const Case& one : some) {
            judge(one, rows, result);
            if (run.progress) run.progress(++done, honest.size() + bad.size());
        }
    };
    judgeAll(honest, result.honest);
    judgeAll(bad, result.bad);
    return result;
}

}  // namespace ticker::selftest
