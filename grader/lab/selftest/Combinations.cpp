#include <grader/base/SplitMix.h>
#include <grader/base/WholeFile.h>
#include <grader/lab/selftest/Combinations.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ticker::selftest {
namespace {

using corpus::Entry;

bool isFit(const Entry& entry) {
    const auto passes = [](const auto& task) {
        return task.second.passes() && !task.second.needsReview;
    };
    return entry.alone.empty() && entry.edits.size() == 1 && entry.files.empty() &&
           entry.made.empty() && std::ranges::all_of(entry.tasks, passes);
}

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

/// Whether the edits apply one after the other: each `find` occurs once in the text that the
/// earlier edits leave.
bool allApply(const std::vector<corpus::Edit>& edits, std::string text) {
    return std::ranges::all_of(edits, [&](const corpus::Edit& edit) {
        if (occurrences(text, edit.find) != 1) return false;
        text.replace(text.find(edit.find), edit.find.size(), edit.replace);
        return true;
    });
}

/// One entry with the edits of both, or nothing if these do not apply together.
std::optional<Entry> combined(Entry first, const Entry& second) {
    const std::string& file = second.edits.begin()->first;
    if (first.base != second.base || !first.edits.contains(file)) return std::nullopt;
    first.name += "+" + second.name;
    first.about += ", and " + second.about;
    const std::vector<corpus::Edit>& added = second.edits.at(file);
    first.edits[file].insert(first.edits[file].end(), added.begin(), added.end());
    first.tasks.insert(second.tasks.begin(), second.tasks.end());
    for (auto& [id, expected] : first.tasks)
        expected.findings.reset();
    if (!allApply(first.edits[file], readWhole(first.base / file))) return std::nullopt;
    return first;
}

}  // namespace

std::vector<Entry> drawCombinations(std::vector<Entry> accepted, std::size_t count,
                                    std::uint64_t seed) {
    constexpr std::size_t kAttemptsEach = 50;
    constexpr std::size_t kMost = 4;
    std::erase_if(accepted, [](const Entry& entry) { return !isFit(entry); });
    std::vector<Entry> drawn;
    if (accepted.size() < 2) return drawn;
    std::set<std::set<std::size_t>> tried;
    for (std::size_t i = 0; i < count * kAttemptsEach && drawn.size() < count; ++i) {
        std::set<std::size_t> chosen;
        const std::size_t size = 2 + splitMix(seed) % (kMost - 1);
        for (std::size_t j = 0; j < size; ++j)
            chosen.insert(splitMix(seed) % accepted.size());
        if (chosen.size() < 2 || !tried.insert(chosen).second) continue;
        std::optional<Entry> together = accepted[*chosen.begin()];
        for (auto next = std::next(chosen.begin()); together && next != chosen.end(); ++next)
            together = combined(*std::move(together), accepted[*next]);
        if (together) drawn.push_back(*std::move(together));
    }
    return drawn;
}

}  // namespace ticker::selftest
