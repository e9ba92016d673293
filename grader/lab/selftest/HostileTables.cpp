#include <grader/lab/selftest/HostileTables.h>

#include <grader/base/Workers.h>
#include <grader/intake/Intake.h>
#include <grader/picture/DecodePicture.h>
#include <grader/result/Names.h>
#include <grader/result/ResultJson.h>

#include <raytracer/base/Error.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <mutex>

namespace ticker::selftest {
namespace fs = std::filesystem;
namespace {

using corpus::Entry;

std::vector<Entry> pick(const std::vector<Entry>& corpus, double fraction) {
    const auto wanted = static_cast<std::size_t>(fraction * static_cast<double>(corpus.size()));
    const std::size_t count = std::clamp<std::size_t>(wanted, 1, corpus.size());
    std::vector<Entry> picked;
    for (std::size_t i = 0; i < count; ++i)
        picked.push_back(corpus[i * corpus.size() / count]);
    return picked;
}

bool holds(const std::vector<std::string>& list, const std::string& value) {
    return std::ranges::find(list, value) != list.end();
}

std::vector<std::string> findingsOf(const SubmissionResult& result) {
    std::vector<std::string> ids;
    for (const TaskReport& task : result.tasks)
        for (const Finding& finding : task.findings)
            if (!holds(ids, finding.id)) ids.push_back(finding.id);
    return ids;
}

/// The expected findings of an entry, if any.
std::vector<std::string> findingsOf(const Entry& hostileCase) {
    return hostileCase.expected().findings.value_or(std::vector<std::string>{});
}

std::string expectedOf(const Entry& hostileCase) {
    return fmt::format(
        "{} {} [{}] {}", hostileCase.task(), fmt::join(hostileCase.expected().states, "|"),
        fmt::join(findingsOf(hostileCase), "|"), fmt::join(hostileCase.verdicts, "|"));
}

// True if the expected finding must be reported even though the task passes, such as a fault of the
// picture.
bool mustBeNamed(const Entry& hostileCase, const std::string& state) {
    if (findingsOf(hostileCase).empty()) return false;
    return hostileCase.expected().passes() || state == "failed" || state == "blocked";
}

// True for names of the class's own files in OUT, which a submission's folder would replace. Some
// file systems ignore case. The list is independent of intake's own, which it tests.
bool takesAPlaceInOut(std::string name) {
    constexpr std::array kFiles{"index.html",   "results.json", "results.sqlite",
                                "similar.html", "similar.json", "summary.csv"};
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::ranges::find(kFiles, name) != kFiles.end();
}

// Whether a notice holds control characters. It must be one line for terminals and logs, whatever
// names it holds. Control characters above ASCII are the byte pairs C2 80 to C2 9F.
bool holdsControls(const std::string& notice) {
    unsigned char before = 0;
    for (const char c : notice) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7F || (before == 0xC2 && byte < 0xA0)) return true;
        before = byte;
    }
    return false;
}

void compare(const Entry& hostileCase, const SubmissionResult& result, HostileRow& row) {
    const auto task = std::ranges::find(result.tasks, hostileCase.task(), &TaskReport::id);
    const std::string state{task == result.tasks.end() ? "none" : toString(task->state)};
    const std::string verdict{toString(result.verdict)};
    const std::vector<std::string> ids = findingsOf(result);
    row.got = fmt::format("{} {} [{}] {}", hostileCase.task(), state, fmt::join(ids, "|"), verdict);
    if (!holds(hostileCase.expected().states, state)) row.faults.push_back("state " + state);
    if (!holds(hostileCase.verdicts, verdict)) row.faults.push_back("verdict " + verdict);
    if (std::ranges::any_of(result.notices, holdsControls))
        row.faults.emplace_back("a control character in a notice");
    if (takesAPlaceInOut(result.submission)) row.faults.push_back("named " + result.submission);
    const bool isNamed = std::ranges::any_of(findingsOf(hostileCase),
                                             [&](const std::string& id) { return holds(ids, id); });
    if (mustBeNamed(hostileCase, state) && !isNamed) {
        const std::string why = task == result.tasks.end() ? "" : task->reason;
        row.faults.push_back("not named as expected: " + why);
    }
}

// Whether any text of a result contains the secret.
bool tells(const SubmissionResult& result, const std::string& secret) {
    if (resultJson(result).find(secret) != std::string::npos) return true;
    for (const Diagnostics& said : result.diagnostics)
        if (said.text.find(secret) != std::string::npos) return true;
    for (const SourceText& source : result.sources)
        if (source.bytes.find(secret) != std::string::npos) return true;
    return std::ranges::any_of(result.pictures, [&](const ResultPicture& picture) {
        return picture.png.find(secret) != std::string::npos;
    });
}

/// The cases written as a class, and their rows.
class HostileClass {
public:
    HostileClass(std::vector<Entry> cases, const pipeline::Grader& grader, const HostileRun& run)
        : cases_(std::move(cases)),
          grader_(grader),
          run_(run),
          rows_(cases_.size() * static_cast<std::size_t>(std::max(1, run.rounds))) {
        const fs::path folder = traces_.folder() / "class";
        fs::create_directory(folder);
        for (const Entry& hostileCase : cases_) {
            const fs::path own = folder / hostileCase.folderName;
            fs::create_directory(own);
            corpus::writeSubmission(hostileCase, traces_.secretFile(), own);
        }
        for (const intake::Located& located : intake::findSubmissions(folder))
            located_[located.path.lexically_relative(folder).begin()->string()] = located;
    }

    [[nodiscard]] HostileTables grade() {
        HostileTables tables;
        warmUp();
        tables.before = footprint(grader_.policy.users);
        onWorkers(run_.jobs, rows_.size(), [this](std::size_t i) { work(i); });
        tables.after = footprint(grader_.policy.users);
        tables.rows = std::move(rows_);
        return tables;
    }

private:
    // Creates the files that each process creates once, those of the first grading and the
    // decoder's copy, so that they do not count as left behind.
    void warmUp() const {
        constexpr std::string_view kBeginning{"\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1", 24};
        static_cast<void>(gradeOne(cases_.front()));
        static_cast<void>(
            picture::decodePicture(kBeginning, grader_.sandbox, grader_.policy.decode));
    }

    void work(std::size_t i) {
        rows_[i] = gradeOne(cases_[i % cases_.size()]);
        rows_[i].round = static_cast<int>(i / cases_.size());
        const std::lock_guard lock{mutex_};
        ++done_;
        if (run_.progress) run_.progress(done_, rows_.size());
    }

    [[nodiscard]] HostileRow gradeOne(const Entry& hostileCase) const {
        HostileRow row{hostileCase.name, 0, expectedOf(hostileCase), "", {}};
        const auto located = located_.find(hostileCase.folderName);
        // Intake found no submission: counts as refused.
        if (located == located_.end()) {
            row.got = "no submission found";
            if (!holds(hostileCase.expected().states, "notAttempted"))
                row.faults.push_back(row.got);
            return row;
        }
        try {
            const intake::Submission submission = intake::readSubmission(located->second);
            SubmissionResult result = pipeline::gradeSubmission(submission, grader_, run_.seed);
            if (run_.complete) run_.complete(submission, result);
            compare(hostileCase, result, row);
            if (tells(result, traces_.secret())) row.faults.emplace_back("the secret is out");
        } catch (const raytracer::Error& error) {
            row.got = error.what();
            row.faults.push_back("stopped the grader: " + row.got);
        }
        if (traces_.takeEscaped()) row.faults.emplace_back("a file outside");
        for (const std::string& process : processesLeft(grader_.policy.users))
            row.faults.push_back("a process is left: " + process);
        return row;
    }

    Traces traces_;
    std::vector<Entry> cases_;
    const pipeline::Grader& grader_;
    const HostileRun& run_;
    std::map<std::string, intake::Located> located_;
    std::vector<HostileRow> rows_;
    std::mutex mutex_;
    std::size_t done_ = 0;
};

}  // namespace

std::size_t HostileTables::right() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(rows, [](const HostileRow& row) { return row.faults.empty(); }));
}

bool HostileTables::passed() const {
    return !rows.empty() && right() == rows.size() && leftBehind(before, after).empty();
}

std::string HostileTables::table() const {
    std::string text;
    for (const HostileRow& row : rows) {
        if (row.round > 0 && row.faults.empty()) continue;
        text += fmt::format("{:<5} {:<30} {}\n", row.faults.empty() ? "ok" : "WRONG", row.name,
                            row.got);
        if (row.faults.empty()) continue;
        text += fmt::format("      expected {}\n", row.expected);
        for (const std::string& fault : row.faults)
            text += fmt::format("      {}\n", fault);
    }
    text += fmt::format("{} of {} hostile submissions as expected\n", right(), rows.size());
    const auto line = [&](const char* when, const Footprint& at) {
        text += fmt::format(
            "{:<6} {} processes, {} files, {} mounts; {:.0f} MB of our own, {:.0f} MB shared, "
            "{:.0f} MB available\n",
            when, at.processes, at.files, at.mounts, at.residentMb, at.sharedMb, at.availableMb);
    };
    line("before", before);
    line("after", after);
    for (const std::string& left : leftBehind(before, after))
        text += fmt::format("WRONG {}\n", left);
    return text;
}

HostileTables runHostileTables(const std::vector<Entry>& corpus, const pipeline::Grader& grader,
                               const HostileRun& run) {
    if (corpus.empty()) return {};
    return HostileClass{pick(corpus, run.fraction), grader, run}.grade();
}

}  // namespace ticker::selftest
