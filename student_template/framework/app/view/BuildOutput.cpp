#include "BuildOutput.h"

#include "Lines.h"

#include <raytracer/base/Text.h>

#include <algorithm>
#include <cstddef>
#include <regex>
#include <utility>
#include <vector>

namespace raytracer::view {
namespace {

// Longer than any line that tells something.
constexpr std::size_t kLongestLine = 2000;

/// The line without the carriage return that Windows writes, cut to `kLongestLine` bytes.
std::string withoutReturn(std::string line) {
    line.resize(std::min(line.size(), kLongestLine));
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

void TestReader::add(std::string_view bytes) {
    for (const char c : bytes) {
        if (c == '\n') {
            readLine();
            continue;
        }
        line_ += c;
        if (line_.size() > 2 * kLongestLine) line_.erase(0, kLongestLine);
    }
}

void TestReader::readLine() {
    constexpr std::string_view kNotYet = "NOT YET: ";
    // It may stand within a line: the student's code may have printed text without a line end.
    const std::size_t start = line_.find(kNotYet);
    const bool isNotYet = start != std::string::npos;
    if (isNotYet) line_.erase(0, start + kNotYet.size());
    const std::string line = withoutReturn(std::exchange(line_, {}));
    if (isNotYet) {
        // The tests of the tasks run in any order.
        isInside_ = isWanted(tagOf(line), tasks_) &&
                    (!outcome_.hasFailed || tagOf(line) < tagOf(outcome_.title));
        if (!isInside_) return;
        outcome_.hasFailed = true;
        outcome_.title = line;
        outcome_.text.clear();
    } else if (isWanted(tagOf(line), tasks_)) {
        isInside_ = false;
        outcome_.summary += line + "\n";
    } else if (isInside_ && line.empty()) {
        isInside_ = false;
    } else if (isInside_) {
        outcome_.text += line + "\n";
    }
}

void TestReader::addEarlyEnd(const std::string& task, std::string_view how,
                             std::string_view output) {
    const std::string words = task + " " + std::string{how};
    outcome_.summary += words + "\n";
    if (!outcome_.hasFailed) outcome_ = {true, words, std::string{output}, outcome_.summary};
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
