#include "BuildOutput.h"

#include "Lines.h"

#include <raytracer/base/Text.h>

#include <algorithm>
#include <cstddef>
#include <regex>
#include <vector>

namespace raytracer::view {
namespace {

/// Without the end that Windows writes, and cut where it is longer than any that tells something.
std::string withoutReturn(std::string line) {
    constexpr std::size_t kLongest = 2000;
    line.resize(std::min(line.size(), kLongest));
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return line;
}

/// The tag that a line of the public tests begins with: letters and digits up to a space.
std::string tagOf(std::string_view line) {
    const std::string tag{line.substr(0, line.find(' '))};
    static const std::regex kTag{R"([TM]\d+(\.\d+)?)"};
    return std::regex_match(tag, kTag) ? tag : std::string{};
}

bool isWanted(const std::string& tag, const std::set<std::string>& tasks) {
    return !tag.empty() && (tasks.empty() || tasks.contains(tag));
}

}  // namespace

std::optional<FirstError> firstErrorIn(std::string_view output) {
    static const std::regex kPlace{
        R"(^(.+?)[:(](\d+)(?:[:,]\d+)?\)?\s*: (?:fatal )?error\s?\w*: (.*)$)"};
    static const std::regex kLinker{
        R"(.*(undefined reference|undefined symbol|multiple definition|duplicate symbol|LNK\d+).*)"};
    std::optional<FirstError> ofLinker;
    for (const std::string& raw : splitAt(output, '\n')) {
        const std::string line = withoutReturn(raw);
        std::smatch match;
        if (std::regex_match(line, match, kPlace))
            return FirstError{match[1], static_cast<int>(parseCount(match[2].str()).value_or(0)),
                              match[3]};
        if (!ofLinker && std::regex_match(line, kLinker)) ofLinker = FirstError{{}, 0, line};
    }
    return ofLinker;
}

TestOutcome testOutcomeIn(std::string_view output, const std::set<std::string>& tasks) {
    constexpr std::string_view kNotYet = "NOT YET: ";
    TestOutcome outcome;
    bool isInside = false;
    for (const std::string& raw : splitAt(output, '\n')) {
        const std::string line = withoutReturn(raw);
        if (line.starts_with(kNotYet)) {
            const std::string title = line.substr(kNotYet.size());
            // The tests of the tasks run in any order.
            isInside = isWanted(tagOf(title), tasks) &&
                       (!outcome.hasFailed || tagOf(title) < tagOf(outcome.title));
            if (!isInside) continue;
            outcome.hasFailed = true;
            outcome.title = title;
            outcome.text.clear();
        } else if (isWanted(tagOf(line), tasks)) {
            isInside = false;
            outcome.summary += line + "\n";
        } else if (isInside && line.empty()) {
            isInside = false;
        } else if (isInside) {
            outcome.text += line + "\n";
        }
    }
    return outcome;
}

std::set<std::string> tasksIn(std::string_view source) {
    static const std::regex kMark{R"(//\s*TASK\s+(\S+)\s+begin\b.*)"};
    std::set<std::string> tasks;
    for (const std::string& raw : splitAt(source, '\n')) {
        const std::string line = withoutReturn(raw);
        const std::size_t comment = line.find("//");
        std::smatch match;
        const std::string mark = comment == std::string::npos ? "" : line.substr(comment);
        if (std::regex_match(mark, match, kMark)) tasks.insert(match[1]);
    }
    return tasks;
}

}  // namespace raytracer::view
