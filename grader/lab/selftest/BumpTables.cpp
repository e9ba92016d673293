#include <grader/lab/selftest/BumpTables.h>

#include <grader/tasks/bump/BumpFindings.h>
#include <grader/tasks/bump/JudgeBump.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ticker::selftest {
namespace {

constexpr std::array kGainNames{
    "unit tangents", "P_u by sin theta", "P_u by 1 / sin theta", "slopes over (u, v)",
    "Blinn's form",  "cross products",   "displaced surface",    "displaced unit sphere"};
/// Indices of a share of `count` elements, evenly spread.
std::vector<std::size_t> sample(std::size_t count, double fraction) {
    const double step = 1.0 / std::clamp(fraction, 1e-3, 1.0);
    std::vector<std::size_t> chosen;
    for (double at = 0.0; at < static_cast<double>(count); at += step)
        chosen.push_back(static_cast<std::size_t>(at));
    return chosen;
}

struct Case {
    Reading reading;
    Mistake mistake = Mistake::none;
    std::uint64_t seed = 0;
    std::size_t row = 0;
};

std::vector<Case> acceptedCases(double fraction, const std::vector<std::uint64_t>& seeds) {
    const std::vector<Reading> readings = acceptedReadings(seeds.front());
    std::vector<Case> cases;
    for (const std::size_t i : sample(readings.size() * seeds.size(), fraction)) {
        const Reading& reading = readings[i % readings.size()];
        cases.push_back({reading, Mistake::none, seeds[i / readings.size()],
                         static_cast<std::size_t>(reading.gain)});
    }
    return cases;
}

/// All combinations of mistakes and readings that can have them.
std::vector<Case> mistakenCases() {
    const std::vector<Reading> readings = readingsForMistakes();
    std::vector<Case> cases;
    std::size_t row = 0;
    for (const Mistake mistake : allMistakes()) {
        for (const Reading& reading : readings)
            if (canHaveMistake(reading, mistake))
                cases.push_back({fittingFor(mistake, reading), mistake, 0, row});
        ++row;
    }
    return cases;
}

std::vector<Case> refusedCases(double fraction, const std::vector<std::uint64_t>& seeds) {
    const std::vector<Case> all = mistakenCases();
    std::vector<Case> cases;
    for (const std::size_t i : sample(all.size(), fraction)) {
        cases.push_back(all[i]);
        cases.back().seed = seeds[i % seeds.size()];
    }
    return cases;
}

std::string firstFailure(const TaskJudgement& judgement) {
    const auto found =
        std::find_if(judgement.findings.begin(), judgement.findings.end(),
                     [](const Finding& finding) { return finding.severity == Severity::fail; });
    return found == judgement.findings.end() ? std::string{} : found->id;
}

/// Whether a finding names another mistake than the expected one. bump.wrong names none.
bool isMisleading(const std::string& expected, const std::string& got) {
    return !got.empty() && got != expected && got != tasks::kBumpWrong.id;
}

void judge(const Case& one, TableRow& row, std::vector<Surprise>& surprises) {
    FunctionExaminee examinee(
        [&](const Point& point) { return modelNormal(one.reading, one.mistake, point); });
    const TaskJudgement judgement = tasks::judgeBump(examinee, one.seed);
    const std::string expected = expectedFinding(one.mistake);
    const std::string got = firstFailure(judgement);
    const bool passed = judgement.state == TaskState::passed;
    ++row.judged;
    if (passed) ++row.passed;
    if (got == expected) ++row.named;
    const bool misleading = isMisleading(expected, got);
    if (misleading) ++row.misleading;
    if (got != expected || passed != expected.empty())
        surprises.push_back({idOf(one.mistake), describe(one.reading), one.seed, expected, got,
                             judgement.reason, passed, misleading});
}

std::string rowText(const TableRow& row) {
    return fmt::format("  {:<34} {:<26} {:>6} {:>7} {:>6} {:>10}\n", row.name, row.expected,
                       row.judged, row.passed, row.named, row.misleading);
}

std::string rowsText(const std::string& title, const std::vector<TableRow>& rows) {
    std::string text = fmt::format("{}\n  {:<34} {:<26} {:>6} {:>7} {:>6} {:>10}\n", title, "",
                                   "expected", "judged", "passed", "named", "misleading");
    TableRow sum{"all", "", 0, 0, 0, 0};
    for (const TableRow& row : rows) {
        text += rowText(row);
        sum.judged += row.judged;
        sum.passed += row.passed;
        sum.named += row.named;
        sum.misleading += row.misleading;
    }
    return text + rowText(sum);
}

}  // namespace

bool BumpSelfTest::passed() const {
    constexpr double kNamed = 0.98;
    int judged = 0;
    int named = 0;
    bool clean = true;
    for (const TableRow& row : accepted)
        clean = clean && row.passed == row.judged;
    for (const TableRow& row : refused) {
        clean = clean && row.passed == 0 && row.misleading == 0;
        judged += row.judged;
        named += row.named;
    }
    return clean && named >= kNamed * judged;
}

std::string BumpSelfTest::table() const {
    std::string text = rowsText("Accepted readings", accepted) + rowsText("Mistakes", refused);
    constexpr std::size_t kShown = 20;
    for (std::size_t i = 0; i < std::min(kShown, surprises.size()); ++i) {
        const Surprise& surprise = surprises[i];
        text +=
            fmt::format("  unexpected: {} with [{}], seed {}: expected \"{}\", got \"{}\": {}\n",
                        surprise.mistake, surprise.reading, surprise.seed, surprise.expected,
                        surprise.got, surprise.message);
    }
    if (surprises.size() > kShown)
        text += fmt::format("  and {} more\n", surprises.size() - kShown);
    return text;
}

BumpSelfTest runBumpSelfTest(double fraction, const std::vector<std::uint64_t>& seeds,
                             const Progress& progress) {
    BumpSelfTest result;
    for (const char* name : kGainNames)
        result.accepted.push_back({name, "passed", 0, 0, 0, 0});
    for (const Mistake mistake : allMistakes())
        result.refused.push_back({idOf(mistake), expectedFinding(mistake), 0, 0, 0, 0});

    const std::vector<Case> accepted = acceptedCases(fraction, seeds);
    const std::vector<Case> refused = refusedCases(fraction, seeds);
    const int total = static_cast<int>(accepted.size() + refused.size());
    int done = 0;
    const auto run = [&](const std::vector<Case>& cases, std::vector<TableRow>& rows) {
        for (const Case& one : cases) {
            judge(one, rows[one.row], result.surprises);
            if (progress) progress(++done, total);
        }
    };
    run(accepted, result.accepted);
    run(refused, result.refused);
    return result;
}

}  // namespace ticker::selftest
